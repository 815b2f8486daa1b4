"""The language server, `lag lsp`: the compiler beside the cursor."""
