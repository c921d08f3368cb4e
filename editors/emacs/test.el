;;; test.el --- eglot and the server, headless  -*- lexical-binding: t; -*-

;; emacs --batch -Q -l test.el, with SCENEC the program, SCENE_FOLDER a folder of its own and SCENE_FILE a scene.
;; Prints a line for each test and leaves with 1 if one failed.

;;; Code:

(require 'package)
(add-to-list 'package-directory-list "/usr/share/emacs/site-lisp/elpa")
(package-initialize)
(require 'eglot)
(add-to-list 'load-path (file-name-directory load-file-name))
(require 'scene-mode)
(require 'cl-lib)

(setq scene-server-command (list (getenv "SCENEC") "lsp")
      ;; A machine may be busy.
      eglot-sync-connect 120
      jrpc-default-request-timeout 120
      jsonrpc-default-request-timeout 120
      eglot-send-changes-idle-time 0
      ;; What eglot itself reports is not the tests' matter.
      inhibit-message t)

(defvar test-passed 0)
(defvar test-failed 0)

(defmacro test (name &rest body)
  "Run BODY as the test NAME."
  (declare (indent 1))
  `(let ((why (condition-case problem (progn ,@body nil) (error (error-message-string problem)))))
     (if why (cl-incf test-failed) (cl-incf test-passed))
     (princ (format "%s emacs: %s%s\n" (if why "FAILED" "ok") ,name (if why (concat ": " why) "")))))

(defun test-wait (what ask)
  "Wait until ASK says yes; WHAT is what for."
  (let ((end (+ (float-time) 120)))
    (while (not (funcall ask))
      (when (> (float-time) end) (error "Timed out: %s" what))
      (accept-process-output nil 0.02))))

(defun test-findings ()
  "The messages of the findings in this buffer."
  (mapcar #'flymake-diagnostic-text (flymake-diagnostics)))

(defun test-found (words)
  "Whether a finding has these WORDS."
  (cl-some (lambda (text) (string-match-p words text)) (test-findings)))

(defun test-change ()
  "Tell the server what was typed."
  (eglot--signal-textDocument/didChange))

(let ((file (expand-file-name "test.scene" (getenv "SCENE_FOLDER"))))
  (copy-file (getenv "SCENE_FILE") file t)
  (find-file file))

(test "the words have colours"
  ;; This eglot asks no server for colours; they are the mode's own.
  (font-lock-ensure)
  (cl-flet ((face (words into)
              (goto-char (point-min))
              (search-forward words)
              (get-text-property (+ (match-beginning 0) into) 'face)))
    (cl-assert (eq (face "!ball ?= red" 1) 'font-lock-variable-name-face))
    (cl-assert (eq (face "!ball ?= red" 0) 'font-lock-keyword-face))
    (cl-assert (eq (face "!ball ?= red" 6) 'font-lock-keyword-face))
    (cl-assert (eq (face "!ball <=" 6) 'font-lock-keyword-face))
    (goto-char (point-max))
    (insert "a := pi / why\n")
    (font-lock-ensure)
    (cl-assert (eq (face "a := pi / why" 5) 'font-lock-constant-face))
    (cl-assert (eq (face "/ why" 2) 'font-lock-comment-face))
    (delete-region (line-beginning-position) (point-max))))

(test "the mode is scene-mode, and the server greets"
  (cl-assert (eq major-mode 'scene-mode))
  (apply #'eglot (eglot--guess-contact))
  (test-wait "a server" #'eglot-current-server)
  (cl-assert (eglot-managed-p)))

(test "findings stand under the words"
  (test-wait "W005" (lambda () (test-found "after the submission"))))

(test "a hover tells of the material"
  (goto-char (point-min))
  (search-forward "?red")
  (backward-char 1)
  (let ((hover (jsonrpc-request (eglot-current-server) :textDocument/hover (eglot--TextDocumentPositionParams))))
    (cl-assert (string-match-p "diffref" (format "%S" hover)) nil "%S" hover)))

(test "a name is completed"
  (goto-char (point-max))
  (insert "!other := ba")
  (test-change)
  (let ((found (jsonrpc-request (eglot-current-server) :textDocument/completion
                                (eglot--TextDocumentPositionParams))))
    (cl-assert (string-match-p "ball" (format "%S" found)) nil "%S" found))
  (delete-region (line-beginning-position) (point-max))
  (test-change))

(test "findings go when the text is mended"
  (goto-char (point-min))
  (search-forward "!ball +=")
  (delete-region (line-beginning-position) (min (point-max) (1+ (line-end-position))))
  (test-change)
  (test-wait "no findings" (lambda () (null (test-findings)))))

(test "renaming reaches every use"
  (goto-char (point-min))
  (search-forward "!ball")
  (backward-char 1)
  (eglot-rename "kugel")
  (cl-assert (not (string-match-p "ball" (buffer-string))) nil "%s" (buffer-string)))

(test "the server ends when it is told to"
  (let* ((server (eglot-current-server)) (process (jsonrpc--process server)))
    (eglot-shutdown server)
    (test-wait "the end" (lambda () (not (process-live-p process))))))

(princ (format "emacs: %d passed, %d failed\n" test-passed test-failed))
(set-buffer-modified-p nil)
(kill-emacs (if (zerop test-failed) 0 1))
;;; test.el ends here
