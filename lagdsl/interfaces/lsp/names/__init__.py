"""Names of a text: their declarations and their uses, class by class, without an instance of any."""
