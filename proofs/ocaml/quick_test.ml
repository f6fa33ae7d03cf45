(* Words and tables do what checker/Word.v and checker/Table.v say of them; and of a certificate: which of its simplices the
   quick check is content with.  quick_test CERTIFICATE: prints how many, and of how many. *)
open Extracted

let expect what holds = if not holds then (prerr_endline ("quick_test: " ^ what); exit 1)

(* wrap, with integers of any length. *)
let wrapped z =
  let half = Big.shift_left Big.one 62 in
  Big.to_int (Big.sub (Big.erem (Big.add z half) (Big.shift_left Big.one 63)) half)

let interesting =
  let near n = [ n - 1; n; n + 1 ] in
  List.concat_map near
    ([ 0; 7; 1 lsl 26; 1 lsl 31; 1 lsl 57; 1 lsl 58; max_int - 1; min_int + 1; max_int / 3; -5; -(1 lsl 26); -(1 lsl 58) ])

let words () =
  let z = Big.of_int in
  List.iter (fun x ->
      expect "down26" (Word.down26 x = Big.to_int (Big.fdiv (z x) (Big.shift_left Big.one 26)));
      expect "down28" (Word.down28 x = Big.to_int (Big.fdiv (z x) (Big.shift_left Big.one 28)));
      expect "size" (Word.size x = if x <= 0 then 0 else Big.numbits (z x));
      expect "to_pos" (Word.to_pos x = if x < 1 then 1 else x);
      if x < 1000 then expect "natural" (Word.natural 0 succ x = max 0 x);
      List.iter (fun y ->
          expect "add" (x + y = wrapped (Big.add (z x) (z y)));
          expect "sub" (x - y = wrapped (Big.sub (z x) (z y)));
          expect "mul" (x * y = wrapped (Big.mul (z x) (z y)));
          expect "less" (Big.less x y = Big.lt (z x) (z y));
          expect "comparisons" (Word.less x y = Big.lt (z x) (z y) && Word.at_most x y = Big.leq (z x) (z y)
                                && Word.equal x y = Big.equal (z x) (z y))) interesting;
      for k = -65 to 65 do
        let inside = k >= 0 && k <= 62 in
        let power = Big.shift_left Big.one (max k 0) in
        expect "up" (Word.up x k = if inside then wrapped (Big.mul (z x) power) else 0);
        expect "down" (Word.down x k = if inside then Big.to_int (Big.fdiv (z x) power) else 0)
      done;
      List.iter (fun s ->
          List.iter (fun big ->
              let y = if s < 0 then Big.zero else Big.fdiv big (Big.shift_left Big.one (min s 200)) in
              let most = Big.shift_left Big.one 58 in
              let fits = s >= 0 && s <= 1 lsl 20 && Big.leq (Big.neg most) y && Big.lt y most in
              expect "fits" (Word.fits s big = fits);
              expect "shifted" (Word.shifted s big = if fits then Big.to_int y else 0))
            [ z x; Big.mul (z x) (z 1000003); Big.mul (z x) (z x) ]) [ -1; 0; 1; 13; 64; 1 lsl 20; 1 lsl 20 + 1 ]) interesting;
  expect "upto" (Word.upto 3 = [ 1; 2; 3 ] && Word.upto 0 = [] && Word.upto (-2) = []);
  let seen = ref [] in
  expect "all" (Word.all 4 (fun k -> seen := k :: !seen; true) && !seen = [ 4; 3; 2; 1 ]
                && not (Word.all 4 (fun k -> k < 4)) && Word.all 0 (fun _ -> false));
  let listed = Words.of_lists (fun l -> List.map succ l) [ [ 5 ]; []; [ 6; max_int - 1 ] ] in
  expect "get" (List.map (Words.get listed) [ -1; 0; 1; 2; 3; min_int; max_int ] = [ 0; 6; 7; max_int; 0; 0; 0 ]);
  let grown = Words.growing 0 in
  for k = 0 to 9999 do Words.add grown (k * k) done;
  let grown = Words.grown grown in
  expect "growing" (List.for_all (fun k -> Words.get grown k = k * k) [ 0; 1023; 1024; 1025; 9999 ] && Words.get grown 10000 = 0);
  let made = ref 0 in
  let once = Table.once (fun () -> incr made; !made) in
  expect "once" (!made = 0 && once () = 1 && once () = 1 && !made = 1);
  let both table = List.map (fun k -> Table.find k table) [ -1; 0; 1; 3; 4 ] in
  expect "tables" (both (Table.of_list (fun x -> x * x) [ 1; 2; 3 ]) = [ None; None; Some 1; Some 9; None ]
                   && both (Table.tabulate 3 (fun k -> k * k)) = [ None; None; Some 1; Some 9; None ])

let () =
  words ();
  if Array.length Sys.argv > 1 then begin
    let channel = open_in_bin Sys.argv.(1) in
    let source = Text.of_string (really_input_string channel (in_channel_length channel)) in
    let space, d = match Text.next_of source "the first line" with _ :: _ :: _ :: "2" :: _ -> (Plane, 2) | _ -> (Space, 3) in
    let c = { Reading.source; d; weighted = false; labels = Reading.no_labels source } in
    let packed, _ = Certificate_file.read c Delaunay in
    let { frame; simplex_count = count; rows_of = rows } = packed in
    let s = Certificate_file.digits_left_out frame and mesh = packed_mesh space packed in
    let places = places_of s frame.points in
    let points = List.length frame.points and w = Word.shifted 0 frame.sample_denominator in
    let content = match space with
      | Plane -> quick_triangle mesh count points rows places s (step_of s frame.sample) w None
      | Space -> quick_simplex mesh count points rows places s (arrow_of s frame.sample) w None in
    Printf.printf "%d of %d, %s\n" (List.length (List.filter content (Word.upto count))) count
      (if quick space packed None s then "content" else "not content")
  end
