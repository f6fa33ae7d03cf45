$LOAD_PATH.unshift "#{ENV['BUILDS']}/src/delaunator-ruby/lib"
require 'delaunator'

# Answers the cases of `circumspect campaign --worker` (docs/workers.md). An exception ends the process with exit code 1.
while (header = $stdin.gets)
  points = Array.new(header.to_i) { $stdin.gets.split.map(&:to_f) }
  made = Delaunator.triangulate(points).each_slice(3).to_a
  puts made.size, made.map { |t| t.join(' ') }
  $stdout.flush
end
