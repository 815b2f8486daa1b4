"""From a tree to the flat model: names, types, dimensions, expansion."""
