"""C++ translation units, parsed by libclang without a build and without installed headers."""
