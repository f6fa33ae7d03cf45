// A worker for `circumspect campaign --worker --limit-memory 0 -- ./mine`: go build mine.go
package main

import (
	"bufio"
	"fmt"
	"os"
	"strings"
)

// Put your own library here: points, one behind the other, and back come rows of indices, from 0.
func triangulate(points []float64, dimension int) [][]int { panic("no library yet") }

func main() {
	in := bufio.NewReader(os.Stdin)
	for c := [6]int{}; ; { // how many points, in which dimension, and of what else a case may have
		if n, _ := fmt.Fscan(in, &c[0], &c[1], &c[2], &c[3], &c[4], &c[5]); n < 6 {
			return
		}
		points := make([]float64, c[0]*c[1])
		for i := range points {
			fmt.Fscan(in, &points[i])
		}
		simplices := triangulate(points, c[1]) // where its documents let it refuse: fmt.Println("error", text)
		fmt.Println(len(simplices))
		for _, row := range simplices {
			fmt.Println(strings.Trim(fmt.Sprint(row), "[]"))
		}
	}
}
