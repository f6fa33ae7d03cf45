/* A worker for `circumspect campaign --worker -- ./mine`: cc -o mine mine.c your_library.c */
#include <stdio.h>
#include <stdlib.h>

/* Put your own library here: it writes rows of dimension + 1 indices, from 0, and returns how many; -1: refused. */
int triangulate(int count, int dimension, const double *points, int *simplices);

int main(void) {
  int n, d, weights, segments, facets, holes;
  while (scanf("%d %d %d %d %d %d", &n, &d, &weights, &segments, &facets, &holes) == 6) {
    double *points = malloc(sizeof(double) * ((size_t)n * d + 1));
    int *simplices = malloc(sizeof(int) * ((size_t)n * n + 1) * (d + 1));
    for (int i = 0; i < n * d; ++i) scanf("%lf", &points[i]);
    const int count = triangulate(n, d, points, simplices);
    if (count < 0) puts("error refused");
    if (count >= 0) printf("%d\n", count);
    for (int i = 0; i < count * (d + 1); ++i) printf("%d%c", simplices[i], (i + 1) % (d + 1) ? ' ' : '\n');
    fflush(stdout);
    free(points);
    free(simplices);
  }
  return 0;
}
