"""Analyses of a program that backends share: what is live, what gets a name, what depends on parameters only."""
