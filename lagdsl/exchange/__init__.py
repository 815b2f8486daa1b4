"""Other tools: FMUs, robots; and the certificate that compares routes."""
