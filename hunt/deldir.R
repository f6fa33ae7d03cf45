source(file.path(dirname(sub("--file=", "", grep("--file=", commandArgs(), value = TRUE))), "lines.R"))
# triMat returns a vector where there is one triangle, and no matrix.
serve(function(p) matrix(deldir::triMat(deldir::deldir(p[, 1], p[, 2])), ncol = 3))
