// What every adapter in Go does: it answers the cases of `circumspect campaign --worker` (docs/workers.md).
package main

import (
	"bufio"
	"fmt"
	"os"
)

// What `triangulate` returns as an error, and a panic, end the process: with exit code 1, and with 2.
func serve(triangulate func(points [][]float64) ([]int, error)) {
	in := bufio.NewReader(os.Stdin)
	out := bufio.NewWriter(os.Stdout)
	for {
		var count, dimension, weights, segments, facets, holes int
		if _, err := fmt.Fscan(in, &count, &dimension, &weights, &segments, &facets, &holes); err != nil {
			return
		}
		points := make([][]float64, count)
		for i := range points {
			points[i] = make([]float64, dimension)
			for k := range points[i] {
				fmt.Fscan(in, &points[i][k])
			}
		}
		flat, err := triangulate(points)
		if err != nil {
			fmt.Fprintln(os.Stderr, err)
			os.Exit(1)
		}
		fmt.Fprintln(out, len(flat)/3)
		for i := 0; i+2 < len(flat); i += 3 {
			fmt.Fprintln(out, flat[i], flat[i+1], flat[i+2])
		}
		out.Flush()
	}
}
