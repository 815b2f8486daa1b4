"""From sources to a tried zip file."""
