"""Answers to an editor: one feature, one file, each a function of a snapshot."""
