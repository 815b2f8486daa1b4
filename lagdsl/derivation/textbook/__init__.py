"""The literal derivation in SymPy: what people read, and the oracle."""
