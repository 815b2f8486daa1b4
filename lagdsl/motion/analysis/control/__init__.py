"""Linear models for control: zeros, transfer functions, margins, frequency responses."""
