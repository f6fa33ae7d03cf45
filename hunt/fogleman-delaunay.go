package main

import "github.com/fogleman/delaunay"

func main() {
	serve(func(points [][]float64) ([]int, error) {
		own := make([]delaunay.Point, len(points))
		for i, p := range points {
			own[i] = delaunay.Point{X: p[0], Y: p[1]}
		}
		made, err := delaunay.Triangulate(own)
		if err != nil {
			return nil, err
		}
		return made.Triangles, nil
	})
}
