% Answers the cases of `circumspect campaign --worker` (docs/workers.md). An error ends the process with exit code 1.
while ischar (header = fgetl (stdin))
  sizes = sscanf (header, "%d");
  points = zeros (sizes(1), sizes(2));
  for i = 1:sizes(1)
    points(i, :) = sscanf (fgetl (stdin), "%f")';
  endfor
  axes = num2cell (points, 1);
  made = delaunay (axes{:}) - 1;
  printf ("%d\n", rows (made));
  printf ([repmat("%d ", 1, sizes(2) + 1) "\n"], made');
  fflush (stdout);
endwhile
