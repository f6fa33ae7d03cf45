# A worker for `circumspect campaign --worker --dimension 2 --limit-time 60s --limit-memory 0 -- julia mine.jl`
import DelaunayTriangulation

# Put your own library here: a vector of points, and back come rows of indices, which Julia counts from 1.
triangulate(points) =
    collect.(DelaunayTriangulation.each_solid_triangle(DelaunayTriangulation.triangulate(points)))

for header in eachline(stdin)
    count = parse(Int, split(header)[1])
    points = [Tuple(parse.(Float64, split(readline(stdin)))) for _ in 1:count]
    simplices = triangulate(points) # where its documents let it refuse: println("error TEXT")
    println(length(simplices))
    foreach(row -> println(join(row .- 1, " ")), simplices)
    flush(stdout)
end
