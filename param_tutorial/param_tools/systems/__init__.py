"""Sets of parameters: of one node or of many, as they are now and as they changed."""
