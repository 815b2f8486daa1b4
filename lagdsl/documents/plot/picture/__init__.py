"""Pictures and films of machines, without a browser."""
