;;; scene-mode.el --- 3D scene files, with eglot  -*- lexical-binding: t; -*-

;; Version: 0.1.0
;; Package-Requires: ((emacs "26.3") (eglot "1.9"))
;; SPDX-License-Identifier: MIT OR Apache-2.0

;;; Commentary:

;; The file type, colours for the words, and the server `scenec lsp' for eglot:
;;
;;     (add-to-list 'load-path "FOLDER OF THIS FILE")
;;     (require 'scene-mode)
;;     (add-hook 'scene-mode-hook #'eglot-ensure)

;;; Code:

(defgroup scene nil "3D scene files." :group 'languages)

(defcustom scene-server-command '("scenec" "lsp")
  "How the server is called."
  :type '(repeat string))

(defvar scene-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?/ "<" table)
    (modify-syntax-entry ?\n ">" table)
    (modify-syntax-entry ?_ "w" table)
    (dolist (character '(?! ?? ?* ?: ?= ?+ ?- ?< ?# ?| ?&))
      (modify-syntax-entry character "." table))
    table)
  "A slash begins a comment, a line ends it.")

(defconst scene-font-lock-keywords
  '(("\\([!?*]\\)[ \t]*\\(\\w+\\)" (1 font-lock-keyword-face) (2 font-lock-variable-name-face))
    ("\\_<pi\\_>" . font-lock-constant-face)
    (":=\\|\\?=\\|\\*=\\|\\+=\\|<=\\|#[xyz]=" . font-lock-keyword-face))
  "Colours for the words.")

;;;###autoload
(define-derived-mode scene-mode prog-mode "Scene"
  "For files that describe a 3D scene, one statement a line."
  (setq-local comment-start "/ ")
  (setq-local comment-start-skip "/[ \t]*")
  (setq-local font-lock-defaults '(scene-font-lock-keywords)))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.\\(?:scene\\|rti\\)\\'" . scene-mode))

(with-eval-after-load 'eglot
  (defvar eglot-server-programs)
  (add-to-list 'eglot-server-programs
               (cons 'scene-mode (lambda (&rest _) scene-server-command))))

(provide 'scene-mode)
;;; scene-mode.el ends here
