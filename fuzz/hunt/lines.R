# What every adapter in R does: reads points from the standard input, writes simplices to the standard output.
serve <- function(triangulate) {
  input <- file("stdin", "r")
  while (length(header <- readLines(input, 1)) > 0) {
    count <- as.integer(strsplit(header, " ")[[1]][1])
    rows <- readLines(input, count)
    points <- do.call(rbind, lapply(strsplit(rows, " "), as.numeric))
    text <- tryCatch({
      made <- suppressWarnings(triangulate(points))
      c(paste(nrow(made), ncol(points) + 1), apply(made - 1, 1, paste, collapse = " "))
    }, error = function(e) paste("raised", gsub("\n.*", "", conditionMessage(e))))
    writeLines(text, stdout())
    flush(stdout())
  }
}
