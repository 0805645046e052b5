"""The exercises, one module for each chapter. No chapter imports another."""
