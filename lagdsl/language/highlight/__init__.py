"""Colours of model texts by rules that follow from the grammar (docs/adr/0033)."""
