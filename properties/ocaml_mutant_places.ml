(* Where generated_mutants.py may break an OCaml source, whose typed tree (FILE.cmt) the compiler wrote:

     ocaml_mutant_places FILE.cmt

   Each line is a place: `replace START END FIRST LAST WORD` (in the expression from START to END, WORD takes the place of
   what stands from FIRST to LAST), `swap START END FIRST LAST BEGIN STOP` (of two arguments), `leave START END` (of
   a statement), `never START END` (of a condition).  All are bytes of the source. *)
open Typedtree

let other = function
  | "<" -> [ "<="; ">=" ] | "<=" -> [ "<"; ">" ] | ">" -> [ ">="; "<=" ] | ">=" -> [ ">"; "<" ]
  | "=" -> [ "<>" ] | "<>" -> [ "=" ] | "==" -> [ "!=" ] | "!=" -> [ "==" ]
  | "&&" -> [ "||" ] | "||" -> [ "&&" ] | "+" -> [ "-" ] | "-" -> [ "+" ] | "not" | "~-" -> [ "" ]
  | "min" -> [ "max" ] | "max" -> [ "min" ] | "List.for_all" -> [ "List.exists" ] | "List.exists" -> [ "List.for_all" ]
  | "Big.add" -> [ "Big.sub" ] | "Big.sub" -> [ "Big.add" ] | "Q.lt" -> [ "Q.leq" ] | "Q.gt" -> [ "Q.geq" ]
  | "Q.mul" -> [ "Q.div" ] | "Q.div" -> [ "Q.mul" ] | "Big.geq" -> [ "Big.gt" ] | _ -> []
(* Of these the order of two arguments makes no difference. *)
let symmetric = [ "*"; "Big.mul"; "Big.min"; "Big.equal"; "Big.lcm"; "Q.equal" ]

let bounds (loc : Location.t) = (loc.loc_start.pos_cnum, loc.loc_end.pos_cnum)
let is_written (e : expression) = not e.exp_loc.loc_ghost
let replace whole part word =
  let start, stop = bounds whole and first, last = bounds part in
  Printf.printf "replace %d %d %d %d %s\n" start stop first last word
let about what (e : expression) =
  let start, stop = bounds e.exp_loc in
  if is_written e then Printf.printf "%s %d %d\n" what start stop

let called (f : expression) = match f.exp_desc with
  | Texp_ident (path, _, _) when is_written f ->
    let name = Path.name path and prefix = "Stdlib." in
    let n = if String.starts_with ~prefix name then String.length prefix else 0 in
    String.sub name n (String.length name - n)
  | _ -> ""

let application (e : expression) f given =
  let name = called f in
  List.iter (replace e.exp_loc f.exp_loc) (other name);
  let same (a : expression) (b : expression) =
    let written t = Format.asprintf "%a" Printtyp.type_expr t in
    (* Two variables may be written alike. *)
    written a.exp_type = written b.exp_type && not (String.contains (written a.exp_type) '\'') in
  let rec pairs = function
    | (Asttypes.Nolabel, Some a) :: ((Asttypes.Nolabel, Some b) :: _ as rest) ->
      let start, stop = bounds e.exp_loc and (first, last), (again, until) = (bounds a.exp_loc, bounds b.exp_loc) in
      if is_written a && is_written b && same a b && last <= again then
        Printf.printf "swap %d %d %d %d %d %d\n" start stop first last again until;
      pairs rest
    | _ :: rest -> pairs rest
    | [] -> () in
  if is_written f && other name = [] && not (List.mem name symmetric) then pairs given

let expression (iterator : Tast_iterator.iterator) (e : expression) =
  (match e.exp_desc with
   | Texp_apply (f, given) when is_written e -> application e f given
   | Texp_constant (Const_int n) when is_written e ->
     replace e.exp_loc e.exp_loc (string_of_int (if n > 1 then n - 1 else if n < 0 then - n else 1 - n))
   | Texp_construct ({ txt = Lident ("true" | "false" as word); _ }, _, []) when is_written e ->
     replace e.exp_loc e.exp_loc (if word = "true" then "false" else "true")
   | Texp_ifthenelse (condition, _, _) -> about "never" condition
   | Texp_sequence (statement, _) -> about "leave" statement
   | _ -> ());
  match e.exp_desc with
  | Texp_assert _ -> ()
  | _ -> Tast_iterator.default_iterator.expr iterator e

let case : type k. Tast_iterator.iterator -> k case -> unit = fun iterator c ->
  Option.iter (about "never") c.c_guard;
  Tast_iterator.default_iterator.case iterator c

let () = match (Cmt_format.read_cmt Sys.argv.(1)).cmt_annots with
  | Implementation structure ->
    let iterator = { Tast_iterator.default_iterator with expr = expression; case } in
    iterator.structure iterator structure
  | _ -> failwith "expected the typed tree of an implementation"
