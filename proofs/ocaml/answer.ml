(* What circumspect-verified says of a certificate or a refutation, alone or beside the user's own files. *)
open Content

(* The arguments are not those of a file: what to say. *)
exception Usage of string
(* Nobody could be told. *)
exception Untold
(* A file that another one names is malformed: which, where, and what was expected and found. *)
exception Malformed_beside of string * int * string

let usage = "usage: circumspect-verified FILE [[--coordinates decimal] [--hole X,Y,Z] [MESH.node MESH.ele] [DOMAIN.poly]]\n\
       circumspect-verified --mesh FILE\n\
       circumspect-verified build delaunay [--coordinates decimal] POINTS.node\n\
FILE is a certificate or a refutation that `circumspect certify` wrote, or a proof that a domain has no\n\
triangulation or CDT, which `circumspect inspect DOMAIN --refutations PREFIX` writes; `-` is standard input.\n\
With your own files it also says whether the mesh is yours: the points by their indices, exactly, and\n\
the simplices in their order; and whether the domain is: its vertices by their exact coordinates, its segments,\n\
polygons and hole points. Decimals mean the nearest double, unless they are taken at their word.\n\
--hole gives the domain a hole point that its file does not list, as `circumspect certify --hole` does. It may\n\
be given several times.\n\
--mesh prints the points and simplices that it is about, as `circumspect compare` reads them, and\n\
checks nothing.\n\
build prints the canonical Delaunay triangulation of the points as an .ele file. It looks at all points from each\n\
facet: a thousand points take minutes."

(* What a channel has left. *)
let read_all channel =
  let buffer = Buffer.create 65536 in
  let chunk = Bytes.create 65536 in
  let rec go () =
    let n = input channel chunk 0 (Bytes.length chunk) in
    if n > 0 then (Buffer.add_subbytes buffer chunk 0 n; go ()) in
  go ();
  Buffer.contents buffer

(* A buffer that grows would hold a file twice: what has a length is read into as much. *)
let read_known channel =
  let length = try in_channel_length channel with Sys_error _ -> 0 in
  let length = if length > Sys.max_string_length then 0 else length in
  let bytes = Bytes.create length in
  let rec filled at = match input channel bytes at (length - at) with 0 -> at | n -> filled (at + n) in
  let known = filled 0 in
  let rest = read_all channel in
  if known = length && rest = "" then Bytes.unsafe_to_string bytes else Bytes.sub_string bytes 0 known ^ rest

let read_file name =
  if name = "-" then (set_binary_mode_in stdin true; read_all stdin)
  else begin
    let channel = open_in_bin name in
    Fun.protect ~finally:(fun () -> close_in_noerr channel) (fun () -> read_known channel)
  end

let malformed_line name line message = Printf.sprintf "malformed: %s:%d: %s" (String.escaped name) line message

(* The line to print if the mesh, and the domain if one is given, is that of the user's files, too; the other
   line if it is another.  It names every file that was read. *)
let of_users_files ~exactly ~further_holes mesh poly content =
  let names_read = ref [] in
  let text_of name =
    let text = Text.of_string (read_file name) in
    names_read := name :: !names_read;
    text in
  let compared what name compare =
    match compare () with
    | result -> Ok result
    | exception Sys_error message ->
      Error (Printf.sprintf "malformed: cannot read %s: %s" (String.escaped name)
               (String.escaped message), 3)
    | exception Users_mesh.Another how ->
      Error (Printf.sprintf "rejected: another %s, %s:%s" what (String.escaped name) how, 1)
    | exception Text.Malformed (line, message) -> Error (malformed_line name line message, 3)
    | exception Malformed_beside (beside, line, message) -> Error (malformed_line beside line message, 3) in
  let of_domain name = match content.compare_domain with
    | None -> Error (Printf.sprintf "rejected: another domain, %s: the certificate is about none" (String.escaped name), 1)
    | Some compare_domain ->
      compared "domain" name (fun () ->
          let source = text_of name in
          let points_elsewhere () =
            let node = Filename.remove_extension name ^ ".node" in
            let source = text_of node in
            try Users_domain.points ~exactly source
            with Text.Malformed (line, message) -> raise (Malformed_beside (node, line, message)) in
          compare_domain points_elsewhere ~further_holes:(List.map snd further_holes) ~exactly source) in
  let ( let* ) = Result.bind in
  (* MESH.face and MESH.edge, those that there are, and what dangles in MESH.ele. *)
  let faces_beside ele mesh number_of short dangling =
    let beside (vertices, extension) =
      let name = Filename.remove_extension ele ^ extension in
      if Sys.file_exists name then Some (vertices, name) else None in
    let files = List.filter_map beside [ (3, ".face"); (2, ".edge") ] in
    let names = List.map snd files in
    let names = if short <> [] || names = [] then ele :: names else names in
    compared "mesh" (String.concat " and " names) (fun () ->
        Users_mesh.compare_faces mesh dangling number_of short
          (List.map (fun (vertices, name) -> (vertices, text_of name)) files)) in
  let same () =
    (* Where the text of the certificate was, these files have room. *)
    Gc.full_major ();
    let* () = match mesh with
      | None -> Ok ()
      | Some (node, ele) ->
        let mesh = Lazy.force content.mesh in
        let* number_of = compared "mesh" node (fun () -> Users_mesh.compare_points ~exactly mesh (text_of node)) in
        let* short = compared "mesh" ele (fun () -> Users_mesh.compare_simplices ~exactly mesh number_of (text_of ele)) in
        Option.fold ~none:(Ok ()) ~some:(faces_beside ele mesh number_of short) mesh.dangling in
    Option.fold ~none:(Ok ()) ~some:of_domain poly in
  (* What a rejected file says is looked at no further. *)
  match content.verdict () with
  | line, 0 -> (match same () with
      | Error answer -> answer
      | Ok () ->
        let names = List.rev_map String.escaped !names_read @ List.map (fun (words, _) -> "--hole " ^ words) further_holes in
        (Printf.sprintf "%s: %s" line (String.concat " " names), 0))
  | answer -> answer

(* A hole point: numbers with commas between them, at their word. *)
let hole words =
  let source = Text.of_string "" in
  let numbers = String.split_on_char ',' words in
  match List.map (Numbered_rows.number ~exactly:true source) numbers with
  | [ _; _ ] | [ _; _; _ ] as place -> (words, place)
  | _ | exception Text.Malformed _ ->
    raise (Usage ("circumspect-verified: expected --hole X,Y,Z or, in the plane, X,Y, found " ^ String.escaped words))

(* The line to print about the file that is named first, and the exit code.  Of a mesh the lines before it are printed. *)
let of_arguments arguments =
  let answer, name = match arguments with
    | [ "--mesh"; name ] -> ((fun content -> (Mesh_text.print (Lazy.force content.mesh), 0)), name)
    | [ name ] -> ((fun content -> content.verdict ()), name)
    | name :: files ->
      let rec options exactly holes = function
        | "--coordinates" :: "decimal" :: files -> options true holes files
        | "--hole" :: words :: files -> options exactly (hole words :: holes) files
        | files -> (exactly, List.rev holes, files) in
      let exactly, further_holes, files = options false [] files in
      (match files with
       | [ poly ] -> (of_users_files ~exactly ~further_holes None (Some poly), name)
       | [ node; ele ] when further_holes = [] -> (of_users_files ~exactly ~further_holes (Some (node, ele)) None, name)
       | [ node; ele; poly ] -> (of_users_files ~exactly ~further_holes (Some (node, ele)) (Some poly), name)
       | _ -> raise (Usage usage))
    | [] -> raise (Usage usage) in
  let shown = String.escaped name in
  let refused why = (Printf.sprintf "refused: %s %s: nothing is known of what it says" shown why, 3) in
  let malformed message = (Printf.sprintf "malformed: %s%s" shown message, 3) in
  match
    let text = read_file name in
    Limits.allow (String.length text);
    Content.read (Text.of_string text)
  with
  | content ->
    (match answer content with
     | answer -> answer
     | exception Sys_error _ -> raise Untold
     | exception Stack_overflow -> malformed ": too large for the stack"
     | exception Limits.Refused why -> refused why
     | exception Division_by_zero -> malformed ": the scale is zero")
  | exception Reading.Repeated_label label -> ("rejected: labels-different, label " ^ label, 1)
  | exception Text.Malformed (line, message) -> malformed (Printf.sprintf ":%d: %s" line message)
  | exception Sys_error message ->
    (Printf.sprintf "malformed: cannot read %s: %s" shown (String.escaped message), 3)
  | exception Limits.Refused why -> refused why
  | exception Out_of_memory -> malformed ": too large for the memory of this machine"
  | exception Stack_overflow -> malformed ": a line is too long for the stack"
