// The sample book's ladder is known by this file.
