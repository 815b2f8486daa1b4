"""The ground under all: places, messages, units, numbers, files."""
