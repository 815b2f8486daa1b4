"""Rules by which `tidy` makes expressions short."""
