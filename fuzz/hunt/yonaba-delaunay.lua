package.path = os.getenv("BUILDS") .. "/src/yonaba-delaunay/?.lua;" .. package.path
local Delaunay = require("delaunay")

-- Reads points from the standard input, writes triangles to the standard output.
for header in io.lines() do
  local points = {}
  for i = 1, tonumber(header:match("^%d+")) do
    local x, y = io.read("l"):match("(%S+) (%S+)")
    points[i] = Delaunay.Point(tonumber(x), tonumber(y))
    points[i].own = i - 1
  end
  local fine, made = pcall(Delaunay.triangulate, table.unpack(points))
  if fine then
    io.write(#made, " 3\n")
    for _, t in ipairs(made) do io.write(t.p1.own or -1, " ", t.p2.own or -1, " ", t.p3.own or -1, "\n") end
  else
    io.write("raised ", tostring(made):gsub("\n.*", ""), "\n")
  end
  io.flush()
end
