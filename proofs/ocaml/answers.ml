(* Answers about many files, one after the other, as circumspect-verified answers about one: for proofs/forgeries.py, since a
   program takes longer to start than to check a small file.  answers: reads the arguments of each from a line, separated by tabs;
   prints what the program prints, where the exit code and a space stand before the last line, which begins a new one. *)

(* What one file had made the heap grow by is not held against the next (Limits). *)
let cleared () = if (Gc.quick_stat ()).heap_words > 4_000_000 then Gc.compact ()

let () =
  try
    while true do
      let line, code = try Answer.of_arguments (String.split_on_char '\t' (input_line stdin)) with Answer.Usage why -> (why, 2) in
      Printf.printf "\n%d %s\n%!" code line;
      cleared ()
    done
  with End_of_file -> ()
