source(file.path(dirname(sub("--file=", "", grep("--file=", commandArgs(), value = TRUE))), "lines.R"))
# Corners of 1e3 times the extent: by default the outer rectangle is 10 % wider than the points.
serve(function(p) as.matrix(deldir::triMat(deldir::deldir(p[, 1], p[, 2]))))
