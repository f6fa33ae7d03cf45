% Judges Octave's own triangulation, and one that is not Delaunay: octave check.m
points = [0 0; 1 0; 0 1; 0.9 0.9];
[holds, said] = circumspect_check (points, delaunay (points(:, 1), points(:, 2)));
printf ("%s", said);
assert (holds);
[holds, said] = circumspect_check (points, [1 2 3; 2 4 3]);
printf ("%s", said);
assert (! holds);
