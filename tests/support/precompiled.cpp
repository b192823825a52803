// Gives the library of test support one source that needs nothing but the precompiled header.
