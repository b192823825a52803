// The sample book has no components to wake.
