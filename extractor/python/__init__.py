"""Python sources: read by the standard `ast` module, never imported or run; the facts are those of C++ sources."""
