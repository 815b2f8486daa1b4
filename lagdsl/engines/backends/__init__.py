"""From a program to texts in another language."""
