"""Many runs of one model: over values of its parameters and starts, over draws from distributions; one dataset."""
