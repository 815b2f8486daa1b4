"""Sections of a derivation report, each from the page that they share."""
