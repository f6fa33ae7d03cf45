(* What a file may cost: processor time and memory, in proportion to its size.  A file that asks for more is refused, and nothing is said
   of it: so nobody can be kept waiting by a file of a megabyte.  Honest files take a small part of this. *)
exception Refused of string

let seconds bytes = 10. +. float bytes *. 10e-6
let words bytes = (150_000_000 + 100 * bytes) / 8

(* Looked at twenty times a second of the processor's. *)
let allow bytes =
  let start = Sys.time () in
  let look _ =
    if Sys.time () -. start > seconds bytes then raise (Refused "takes more time than its size allows");
    if (Gc.quick_stat ()).heap_words > words bytes then raise (Refused "takes more memory than its size allows") in
  Sys.set_signal Sys.sigvtalrm (Sys.Signal_handle look);
  ignore (Unix.setitimer Unix.ITIMER_VIRTUAL { Unix.it_interval = 0.05; it_value = 0.05 } : Unix.interval_timer_status)
