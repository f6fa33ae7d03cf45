source(file.path(dirname(sub("--file=", "", grep("--file=", commandArgs(), value = TRUE))), "lines.R"))
serve(function(p) geometry::delaunayn(p))
