(* Lists of words, as checker/Word.v says, in memory without pointers; those that are read grow. *)
open Bigarray
type t = (int, int_elt, c_layout) Array1.t

let get (words : t) k =
  if k >= 0 && k < Array1.dim words then Array1.unsafe_get words k else 0 [@@inline]

type growing = { mutable held : t; mutable count : int }
let growing expected = { held = Array1.create Int C_layout (max 1024 expected); count = 0 }
let add grown word =
  if grown.count = Array1.dim grown.held then begin
    let larger = Array1.create Int C_layout (grown.count + grown.count / 2) in
    Array1.blit grown.held (Array1.sub larger 0 grown.count);
    grown.held <- larger
  end;
  Array1.unsafe_set grown.held grown.count word;
  grown.count <- grown.count + 1
let grown words = Array1.sub words.held 0 words.count

let of_lists words things =
  let made = growing (List.length things) in
  List.iter (fun thing -> List.iter (add made) (words thing)) things;
  grown made
