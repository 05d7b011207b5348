// What is compiled for the precompiled headers of the tests: nothing.
