// What every adapter in Go does: reads points from the standard input, writes triangles to the standard output.
package main

import (
	"bufio"
	"fmt"
	"os"
	"strings"
)

func serve(triangulate func(points [][]float64) ([]int, error)) {
	in := bufio.NewReader(os.Stdin)
	out := bufio.NewWriter(os.Stdout)
	for {
		var count, dimension int
		if _, err := fmt.Fscan(in, &count, &dimension); err != nil {
			return
		}
		points := make([][]float64, count)
		for i := range points {
			points[i] = make([]float64, dimension)
			for k := range points[i] {
				fmt.Fscan(in, &points[i][k])
			}
		}
		flat, err := caught(triangulate, points)
		if err != nil {
			fmt.Fprintf(out, "raised %s\n", strings.Split(err.Error(), "\n")[0])
		} else {
			fmt.Fprintf(out, "%d 3\n", len(flat)/3)
			for i := 0; i+2 < len(flat); i += 3 {
				fmt.Fprintln(out, flat[i], flat[i+1], flat[i+2])
			}
		}
		out.Flush()
	}
}

func caught(triangulate func([][]float64) ([]int, error), points [][]float64) (made []int, err error) {
	defer func() {
		if cause := recover(); cause != nil {
			err = fmt.Errorf("panic: %v", cause)
		}
	}()
	return triangulate(points)
}
