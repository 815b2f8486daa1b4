"""Pages about what comes with the compiler: the classes of the library, the models to start from."""
