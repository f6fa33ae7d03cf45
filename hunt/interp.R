source(file.path(dirname(sub("--file=", "", grep("--file=", commandArgs(), value = TRUE))), "lines.R"))
serve(function(p) interp::triangles(interp::tri.mesh(p[, 1], p[, 2]))[, 1:3, drop = FALSE])
