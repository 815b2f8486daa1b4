"""Generated code at work: built, loaded, called."""
