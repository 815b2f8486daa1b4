"""The derivation report and the tables of the command line."""
