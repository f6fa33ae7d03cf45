% A worker for `circumspect campaign --worker -- octave-cli --no-init-file mine.m`: it answers each case with simplices.
1;
% Put your own library here: a matrix with a row for each point, and back comes one of indices, which Octave counts from 1.
function simplices = triangulate(points)
  simplices = delaunayn(points);
end

while ischar(header = fgetl(stdin))
  counts = sscanf(header, "%d");
  points = zeros(counts(1), counts(2));
  for i = 1:counts(1)
    points(i, :) = sscanf(fgetl(stdin), "%f")(1:counts(2));
  end
  try
    simplices = triangulate(points) - 1;
    printf("%d\n", rows(simplices));
    printf([repmat("%d ", 1, columns(simplices)) "\n"], simplices');
  catch problem % what its documents let it refuse
    printf("error %s\n", strtok(problem.message, "\n"));
  end
  fflush(stdout);
end
