# What every adapter in R does: it answers the cases of `circumspect campaign --worker` (docs/workers.md).
serve <- function(triangulate) {
  input <- file("stdin", "r")
  while (length(header <- readLines(input, 1)) > 0) {
    count <- as.integer(strsplit(header, " ")[[1]][1])
    rows <- readLines(input, count)
    points <- do.call(rbind, lapply(strsplit(rows, " "), as.numeric))
    made <- suppressWarnings(triangulate(points)) # an error ends the process with exit code 1
    writeLines(c(as.character(nrow(made)), apply(made - 1, 1, paste, collapse = " ")), stdout())
    flush(stdout())
  }
}
