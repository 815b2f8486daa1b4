"""Which numbers of a program depend on which, with the zeros that cancellation leaves removed."""
