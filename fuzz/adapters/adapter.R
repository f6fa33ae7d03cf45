# A worker for `circumspect campaign --worker -- Rscript mine.R`: it answers each case with simplices.
suppressMessages(library(geometry))

# Put your own library here: a matrix with a row for each point, and back comes one of indices, which R counts from 1.
triangulate <- function(points) delaunayn(points)

input <- file("stdin", "r")
while (length(header <- readLines(input, n = 1)) > 0) {
  counts <- as.integer(strsplit(header, " ")[[1]])
  rows <- strsplit(readLines(input, n = counts[1]), " ")
  points <- matrix(as.numeric(unlist(rows)), ncol = counts[2], byrow = TRUE)
  simplices <- triangulate(points) - 1  # where its documents let it refuse: cat("error TEXT\n")
  cat(nrow(simplices), "\n", sep = "")
  for (i in seq_len(nrow(simplices))) cat(simplices[i, ], "\n")
  flush(stdout())
}
