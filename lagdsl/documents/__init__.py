"""Texts and pictures for people: derivations, plots, living pages."""
