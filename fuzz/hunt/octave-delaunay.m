% Reads points from the standard input, writes simplices to the standard output.
while ischar (header = fgetl (stdin))
  sizes = sscanf (header, "%d");
  points = zeros (sizes(1), sizes(2));
  for i = 1:sizes(1)
    points(i, :) = sscanf (fgetl (stdin), "%f")';
  endfor
  try
    axes = num2cell (points, 1);
    made = delaunay (axes{:}) - 1;
    printf ("%d %d\n", rows (made), sizes(2) + 1);
    printf ([repmat("%d ", 1, sizes(2) + 1) "\n"], made');
  catch err
    printf ("raised %s\n", strtok (err.message, "\n"));
  end_try_catch
  fflush (stdout);
endwhile
