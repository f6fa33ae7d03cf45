// A worker for `circumspect campaign --worker --limit-memory 0 -- java -XX:-UsePerfData -cp . Mine`: javac Mine.java
import java.util.Scanner;

public class Mine {
  // Put your own library here: an array of points, and back come rows of indices, from 0.
  static int[][] triangulate(double[][] points) {
    throw new UnsupportedOperationException("no library yet");
  }

  public static void main(String[] arguments) {
    Scanner in = new Scanner(new java.io.BufferedInputStream(System.in));
    while (in.hasNextLine()) {
      String[] counts = in.nextLine().split(" ");
      double[][] points = new double[Integer.parseInt(counts[0])][];
      for (int i = 0; i < points.length; ++i)
        points[i] = java.util.Arrays.stream(in.nextLine().split(" ")).mapToDouble(Double::parseDouble).toArray();
      int[][] simplices = triangulate(points); // where its documents let it refuse: println("error TEXT")
      StringBuilder answer = new StringBuilder(simplices.length + "\n");
      for (int[] row : simplices) answer.append(java.util.Arrays.toString(row).replaceAll("[\\[\\],]", "")).append("\n");
      System.out.print(answer);
      System.out.flush();
    }
  }
}
