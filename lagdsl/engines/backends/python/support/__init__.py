"""Support code of every generated NumPy module, besides its own functions.

The other files of this folder are copied into it, so they import numpy and each other only.
"""
