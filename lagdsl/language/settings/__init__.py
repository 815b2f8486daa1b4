"""Values that users assign by name, as texts: `m = 2 kg`, `theta.start = 0:10:90 deg`."""
