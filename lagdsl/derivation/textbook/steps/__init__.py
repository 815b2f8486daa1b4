"""Parts of the lecture's recipe."""
