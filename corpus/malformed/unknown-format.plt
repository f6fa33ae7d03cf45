TITLE = "a mesh"
VARIABLES = "x", "y"
