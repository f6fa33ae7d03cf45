(* circumspect-verified FILE: checks a certificate or a refutation, prints one line.
   circumspect-verified FILE MESH.node MESH.ele [DOMAIN.poly]: the same, and whether the mesh, and the domain, is that
   of these files.
   circumspect-verified FILE DOMAIN.poly: the same, and whether the domain is that of this file.
   circumspect-verified --mesh FILE: prints the mesh that the file is about, and checks nothing.
   circumspect-verified build delaunay POINTS.node: prints the canonical Delaunay triangulation of the points.
   Exit: 0 verified, 1 rejected, 2 usage, 3 malformed or unreadable; anything else (5: nobody could be
   told; a signal, as of a system without memory) is not an answer. *)
(* Takes as long as it takes: the file is the user's own. *)
let build_delaunay ~exactly name =
  match Construction.delaunay ~exactly (Text.of_string (Answer.read_file name)) with
  | rows -> (rows, 0)
  | exception Text.Malformed (line, message) -> (Answer.malformed_line name line message, 3)
  | exception Sys_error message ->
    (Printf.sprintf "malformed: cannot read %s: %s" (String.escaped name) (String.escaped message), 3)

let () =
  (* Little of what is read becomes garbage: collect seldom, and move nothing. *)
  Gc.set { (Gc.get ()) with Gc.space_overhead = 400; max_overhead = 1_000_000; minor_heap_size = 1 lsl 18 };
  match
    let line, code = match List.tl (Array.to_list Sys.argv) with
      | [ ("-h" | "--help") ] -> (Answer.usage, 0)
      | [ "build"; "delaunay"; name ] -> build_delaunay ~exactly:false name
      | [ "build"; "delaunay"; "--coordinates"; "decimal"; name ] -> build_delaunay ~exactly:true name
      | "build" :: _ -> raise (Answer.Usage Answer.usage)
      | arguments -> Answer.of_arguments arguments in
    print_endline line;
    code
  with
  | code -> exit code
  | exception Answer.Usage why -> prerr_endline why; exit 2
  | exception (Answer.Untold | Sys_error _) -> close_out_noerr stdout; exit 5
