"""Models in notebooks: `%load_ext lagdsl`, cells `%%lag name`, tables, bars (docs/adr/0034)."""
