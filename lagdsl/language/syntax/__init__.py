"""The text's shape: parser, printer and tree."""
