// 41: pass|timeout_cpu|memory|crash|compile_error: a thousand functions of one name
struct S0 { float x; };
float f(S0 s) { return s.x; }
struct S1 { float x; };
float f(S1 s) { return s.x; }
struct S2 { float x; };
float f(S2 s) { return s.x; }
struct S3 { float x; };
float f(S3 s) { return s.x; }
struct S4 { float x; };
float f(S4 s) { return s.x; }
struct S5 { float x; };
float f(S5 s) { return s.x; }
struct S6 { float x; };
float f(S6 s) { return s.x; }
struct S7 { float x; };
float f(S7 s) { return s.x; }
struct S8 { float x; };
float f(S8 s) { return s.x; }
struct S9 { float x; };
float f(S9 s) { return s.x; }
struct S10 { float x; };
float f(S10 s) { return s.x; }
struct S11 { float x; };
float f(S11 s) { return s.x; }
struct S12 { float x; };
float f(S12 s) { return s.x; }
struct S13 { float x; };
float f(S13 s) { return s.x; }
struct S14 { float x; };
float f(S14 s) { return s.x; }
struct S15 { float x; };
float f(S15 s) { return s.x; }
struct S16 { float x; };
float f(S16 s) { return s.x; }
struct S17 { float x; };
float f(S17 s) { return s.x; }
struct S18 { float x; };
float f(S18 s) { return s.x; }
struct S19 { float x; };
float f(S19 s) { return s.x; }
struct S20 { float x; };
float f(S20 s) { return s.x; }
struct S21 { float x; };
float f(S21 s) { return s.x; }
struct S22 { float x; };
float f(S22 s) { return s.x; }
struct S23 { float x; };
float f(S23 s) { return s.x; }
struct S24 { float x; };
float f(S24 s) { return s.x; }
struct S25 { float x; };
float f(S25 s) { return s.x; }
struct S26 { float x; };
float f(S26 s) { return s.x; }
struct S27 { float x; };
float f(S27 s) { return s.x; }
struct S28 { float x; };
float f(S28 s) { return s.x; }
struct S29 { float x; };
float f(S29 s) { return s.x; }
struct S30 { float x; };
float f(S30 s) { return s.x; }
struct S31 { float x; };
float f(S31 s) { return s.x; }
struct S32 { float x; };
float f(S32 s) { return s.x; }
struct S33 { float x; };
float f(S33 s) { return s.x; }
struct S34 { float x; };
float f(S34 s) { return s.x; }
struct S35 { float x; };
float f(S35 s) { return s.x; }
struct S36 { float x; };
float f(S36 s) { return s.x; }
struct S37 { float x; };
float f(S37 s) { return s.x; }
struct S38 { float x; };
float f(S38 s) { return s.x; }
struct S39 { float x; };
float f(S39 s) { return s.x; }
struct S40 { float x; };
float f(S40 s) { return s.x; }
struct S41 { float x; };
float f(S41 s) { return s.x; }
struct S42 { float x; };
float f(S42 s) { return s.x; }
struct S43 { float x; };
float f(S43 s) { return s.x; }
struct S44 { float x; };
float f(S44 s) { return s.x; }
struct S45 { float x; };
float f(S45 s) { return s.x; }
struct S46 { float x; };
float f(S46 s) { return s.x; }
struct S47 { float x; };
float f(S47 s) { return s.x; }
struct S48 { float x; };
float f(S48 s) { return s.x; }
struct S49 { float x; };
float f(S49 s) { return s.x; }
struct S50 { float x; };
float f(S50 s) { return s.x; }
struct S51 { float x; };
float f(S51 s) { return s.x; }
struct S52 { float x; };
float f(S52 s) { return s.x; }
struct S53 { float x; };
float f(S53 s) { return s.x; }
struct S54 { float x; };
float f(S54 s) { return s.x; }
struct S55 { float x; };
float f(S55 s) { return s.x; }
struct S56 { float x; };
float f(S56 s) { return s.x; }
struct S57 { float x; };
float f(S57 s) { return s.x; }
struct S58 { float x; };
float f(S58 s) { return s.x; }
struct S59 { float x; };
float f(S59 s) { return s.x; }
struct S60 { float x; };
float f(S60 s) { return s.x; }
struct S61 { float x; };
float f(S61 s) { return s.x; }
struct S62 { float x; };
float f(S62 s) { return s.x; }
struct S63 { float x; };
float f(S63 s) { return s.x; }
struct S64 { float x; };
float f(S64 s) { return s.x; }
struct S65 { float x; };
float f(S65 s) { return s.x; }
struct S66 { float x; };
float f(S66 s) { return s.x; }
struct S67 { float x; };
float f(S67 s) { return s.x; }
struct S68 { float x; };
float f(S68 s) { return s.x; }
struct S69 { float x; };
float f(S69 s) { return s.x; }
struct S70 { float x; };
float f(S70 s) { return s.x; }
struct S71 { float x; };
float f(S71 s) { return s.x; }
struct S72 { float x; };
float f(S72 s) { return s.x; }
struct S73 { float x; };
float f(S73 s) { return s.x; }
struct S74 { float x; };
float f(S74 s) { return s.x; }
struct S75 { float x; };
float f(S75 s) { return s.x; }
struct S76 { float x; };
float f(S76 s) { return s.x; }
struct S77 { float x; };
float f(S77 s) { return s.x; }
struct S78 { float x; };
float f(S78 s) { return s.x; }
struct S79 { float x; };
float f(S79 s) { return s.x; }
struct S80 { float x; };
float f(S80 s) { return s.x; }
struct S81 { float x; };
float f(S81 s) { return s.x; }
struct S82 { float x; };
float f(S82 s) { return s.x; }
struct S83 { float x; };
float f(S83 s) { return s.x; }
struct S84 { float x; };
float f(S84 s) { return s.x; }
struct S85 { float x; };
float f(S85 s) { return s.x; }
struct S86 { float x; };
float f(S86 s) { return s.x; }
struct S87 { float x; };
float f(S87 s) { return s.x; }
struct S88 { float x; };
float f(S88 s) { return s.x; }
struct S89 { float x; };
float f(S89 s) { return s.x; }
struct S90 { float x; };
float f(S90 s) { return s.x; }
struct S91 { float x; };
float f(S91 s) { return s.x; }
struct S92 { float x; };
float f(S92 s) { return s.x; }
struct S93 { float x; };
float f(S93 s) { return s.x; }
struct S94 { float x; };
float f(S94 s) { return s.x; }
struct S95 { float x; };
float f(S95 s) { return s.x; }
struct S96 { float x; };
float f(S96 s) { return s.x; }
struct S97 { float x; };
float f(S97 s) { return s.x; }
struct S98 { float x; };
float f(S98 s) { return s.x; }
struct S99 { float x; };
float f(S99 s) { return s.x; }
struct S100 { float x; };
float f(S100 s) { return s.x; }
struct S101 { float x; };
float f(S101 s) { return s.x; }
struct S102 { float x; };
float f(S102 s) { return s.x; }
struct S103 { float x; };
float f(S103 s) { return s.x; }
struct S104 { float x; };
float f(S104 s) { return s.x; }
struct S105 { float x; };
float f(S105 s) { return s.x; }
struct S106 { float x; };
float f(S106 s) { return s.x; }
struct S107 { float x; };
float f(S107 s) { return s.x; }
struct S108 { float x; };
float f(S108 s) { return s.x; }
struct S109 { float x; };
float f(S109 s) { return s.x; }
struct S110 { float x; };
float f(S110 s) { return s.x; }
struct S111 { float x; };
float f(S111 s) { return s.x; }
struct S112 { float x; };
float f(S112 s) { return s.x; }
struct S113 { float x; };
float f(S113 s) { return s.x; }
struct S114 { float x; };
float f(S114 s) { return s.x; }
struct S115 { float x; };
float f(S115 s) { return s.x; }
struct S116 { float x; };
float f(S116 s) { return s.x; }
struct S117 { float x; };
float f(S117 s) { return s.x; }
struct S118 { float x; };
float f(S118 s) { return s.x; }
struct S119 { float x; };
float f(S119 s) { return s.x; }
struct S120 { float x; };
float f(S120 s) { return s.x; }
struct S121 { float x; };
float f(S121 s) { return s.x; }
struct S122 { float x; };
float f(S122 s) { return s.x; }
struct S123 { float x; };
float f(S123 s) { return s.x; }
struct S124 { float x; };
float f(S124 s) { return s.x; }
struct S125 { float x; };
float f(S125 s) { return s.x; }
struct S126 { float x; };
float f(S126 s) { return s.x; }
struct S127 { float x; };
float f(S127 s) { return s.x; }
struct S128 { float x; };
float f(S128 s) { return s.x; }
struct S129 { float x; };
float f(S129 s) { return s.x; }
struct S130 { float x; };
float f(S130 s) { return s.x; }
struct S131 { float x; };
float f(S131 s) { return s.x; }
struct S132 { float x; };
float f(S132 s) { return s.x; }
struct S133 { float x; };
float f(S133 s) { return s.x; }
struct S134 { float x; };
float f(S134 s) { return s.x; }
struct S135 { float x; };
float f(S135 s) { return s.x; }
struct S136 { float x; };
float f(S136 s) { return s.x; }
struct S137 { float x; };
float f(S137 s) { return s.x; }
struct S138 { float x; };
float f(S138 s) { return s.x; }
struct S139 { float x; };
float f(S139 s) { return s.x; }
struct S140 { float x; };
float f(S140 s) { return s.x; }
struct S141 { float x; };
float f(S141 s) { return s.x; }
struct S142 { float x; };
float f(S142 s) { return s.x; }
struct S143 { float x; };
float f(S143 s) { return s.x; }
struct S144 { float x; };
float f(S144 s) { return s.x; }
struct S145 { float x; };
float f(S145 s) { return s.x; }
struct S146 { float x; };
float f(S146 s) { return s.x; }
struct S147 { float x; };
float f(S147 s) { return s.x; }
struct S148 { float x; };
float f(S148 s) { return s.x; }
struct S149 { float x; };
float f(S149 s) { return s.x; }
struct S150 { float x; };
float f(S150 s) { return s.x; }
struct S151 { float x; };
float f(S151 s) { return s.x; }
struct S152 { float x; };
float f(S152 s) { return s.x; }
struct S153 { float x; };
float f(S153 s) { return s.x; }
struct S154 { float x; };
float f(S154 s) { return s.x; }
struct S155 { float x; };
float f(S155 s) { return s.x; }
struct S156 { float x; };
float f(S156 s) { return s.x; }
struct S157 { float x; };
float f(S157 s) { return s.x; }
struct S158 { float x; };
float f(S158 s) { return s.x; }
struct S159 { float x; };
float f(S159 s) { return s.x; }
struct S160 { float x; };
float f(S160 s) { return s.x; }
struct S161 { float x; };
float f(S161 s) { return s.x; }
struct S162 { float x; };
float f(S162 s) { return s.x; }
struct S163 { float x; };
float f(S163 s) { return s.x; }
struct S164 { float x; };
float f(S164 s) { return s.x; }
struct S165 { float x; };
float f(S165 s) { return s.x; }
struct S166 { float x; };
float f(S166 s) { return s.x; }
struct S167 { float x; };
float f(S167 s) { return s.x; }
struct S168 { float x; };
float f(S168 s) { return s.x; }
struct S169 { float x; };
float f(S169 s) { return s.x; }
struct S170 { float x; };
float f(S170 s) { return s.x; }
struct S171 { float x; };
float f(S171 s) { return s.x; }
struct S172 { float x; };
float f(S172 s) { return s.x; }
struct S173 { float x; };
float f(S173 s) { return s.x; }
struct S174 { float x; };
float f(S174 s) { return s.x; }
struct S175 { float x; };
float f(S175 s) { return s.x; }
struct S176 { float x; };
float f(S176 s) { return s.x; }
struct S177 { float x; };
float f(S177 s) { return s.x; }
struct S178 { float x; };
float f(S178 s) { return s.x; }
struct S179 { float x; };
float f(S179 s) { return s.x; }
struct S180 { float x; };
float f(S180 s) { return s.x; }
struct S181 { float x; };
float f(S181 s) { return s.x; }
struct S182 { float x; };
float f(S182 s) { return s.x; }
struct S183 { float x; };
float f(S183 s) { return s.x; }
struct S184 { float x; };
float f(S184 s) { return s.x; }
struct S185 { float x; };
float f(S185 s) { return s.x; }
struct S186 { float x; };
float f(S186 s) { return s.x; }
struct S187 { float x; };
float f(S187 s) { return s.x; }
struct S188 { float x; };
float f(S188 s) { return s.x; }
struct S189 { float x; };
float f(S189 s) { return s.x; }
struct S190 { float x; };
float f(S190 s) { return s.x; }
struct S191 { float x; };
float f(S191 s) { return s.x; }
struct S192 { float x; };
float f(S192 s) { return s.x; }
struct S193 { float x; };
float f(S193 s) { return s.x; }
struct S194 { float x; };
float f(S194 s) { return s.x; }
struct S195 { float x; };
float f(S195 s) { return s.x; }
struct S196 { float x; };
float f(S196 s) { return s.x; }
struct S197 { float x; };
float f(S197 s) { return s.x; }
struct S198 { float x; };
float f(S198 s) { return s.x; }
struct S199 { float x; };
float f(S199 s) { return s.x; }
struct S200 { float x; };
float f(S200 s) { return s.x; }
struct S201 { float x; };
float f(S201 s) { return s.x; }
struct S202 { float x; };
float f(S202 s) { return s.x; }
struct S203 { float x; };
float f(S203 s) { return s.x; }
struct S204 { float x; };
float f(S204 s) { return s.x; }
struct S205 { float x; };
float f(S205 s) { return s.x; }
struct S206 { float x; };
float f(S206 s) { return s.x; }
struct S207 { float x; };
float f(S207 s) { return s.x; }
struct S208 { float x; };
float f(S208 s) { return s.x; }
struct S209 { float x; };
float f(S209 s) { return s.x; }
struct S210 { float x; };
float f(S210 s) { return s.x; }
struct S211 { float x; };
float f(S211 s) { return s.x; }
struct S212 { float x; };
float f(S212 s) { return s.x; }
struct S213 { float x; };
float f(S213 s) { return s.x; }
struct S214 { float x; };
float f(S214 s) { return s.x; }
struct S215 { float x; };
float f(S215 s) { return s.x; }
struct S216 { float x; };
float f(S216 s) { return s.x; }
struct S217 { float x; };
float f(S217 s) { return s.x; }
struct S218 { float x; };
float f(S218 s) { return s.x; }
struct S219 { float x; };
float f(S219 s) { return s.x; }
struct S220 { float x; };
float f(S220 s) { return s.x; }
struct S221 { float x; };
float f(S221 s) { return s.x; }
struct S222 { float x; };
float f(S222 s) { return s.x; }
struct S223 { float x; };
float f(S223 s) { return s.x; }
struct S224 { float x; };
float f(S224 s) { return s.x; }
struct S225 { float x; };
float f(S225 s) { return s.x; }
struct S226 { float x; };
float f(S226 s) { return s.x; }
struct S227 { float x; };
float f(S227 s) { return s.x; }
struct S228 { float x; };
float f(S228 s) { return s.x; }
struct S229 { float x; };
float f(S229 s) { return s.x; }
struct S230 { float x; };
float f(S230 s) { return s.x; }
struct S231 { float x; };
float f(S231 s) { return s.x; }
struct S232 { float x; };
float f(S232 s) { return s.x; }
struct S233 { float x; };
float f(S233 s) { return s.x; }
struct S234 { float x; };
float f(S234 s) { return s.x; }
struct S235 { float x; };
float f(S235 s) { return s.x; }
struct S236 { float x; };
float f(S236 s) { return s.x; }
struct S237 { float x; };
float f(S237 s) { return s.x; }
struct S238 { float x; };
float f(S238 s) { return s.x; }
struct S239 { float x; };
float f(S239 s) { return s.x; }
struct S240 { float x; };
float f(S240 s) { return s.x; }
struct S241 { float x; };
float f(S241 s) { return s.x; }
struct S242 { float x; };
float f(S242 s) { return s.x; }
struct S243 { float x; };
float f(S243 s) { return s.x; }
struct S244 { float x; };
float f(S244 s) { return s.x; }
struct S245 { float x; };
float f(S245 s) { return s.x; }
struct S246 { float x; };
float f(S246 s) { return s.x; }
struct S247 { float x; };
float f(S247 s) { return s.x; }
struct S248 { float x; };
float f(S248 s) { return s.x; }
struct S249 { float x; };
float f(S249 s) { return s.x; }
struct S250 { float x; };
float f(S250 s) { return s.x; }
struct S251 { float x; };
float f(S251 s) { return s.x; }
struct S252 { float x; };
float f(S252 s) { return s.x; }
struct S253 { float x; };
float f(S253 s) { return s.x; }
struct S254 { float x; };
float f(S254 s) { return s.x; }
struct S255 { float x; };
float f(S255 s) { return s.x; }
struct S256 { float x; };
float f(S256 s) { return s.x; }
struct S257 { float x; };
float f(S257 s) { return s.x; }
struct S258 { float x; };
float f(S258 s) { return s.x; }
struct S259 { float x; };
float f(S259 s) { return s.x; }
struct S260 { float x; };
float f(S260 s) { return s.x; }
struct S261 { float x; };
float f(S261 s) { return s.x; }
struct S262 { float x; };
float f(S262 s) { return s.x; }
struct S263 { float x; };
float f(S263 s) { return s.x; }
struct S264 { float x; };
float f(S264 s) { return s.x; }
struct S265 { float x; };
float f(S265 s) { return s.x; }
struct S266 { float x; };
float f(S266 s) { return s.x; }
struct S267 { float x; };
float f(S267 s) { return s.x; }
struct S268 { float x; };
float f(S268 s) { return s.x; }
struct S269 { float x; };
float f(S269 s) { return s.x; }
struct S270 { float x; };
float f(S270 s) { return s.x; }
struct S271 { float x; };
float f(S271 s) { return s.x; }
struct S272 { float x; };
float f(S272 s) { return s.x; }
struct S273 { float x; };
float f(S273 s) { return s.x; }
struct S274 { float x; };
float f(S274 s) { return s.x; }
struct S275 { float x; };
float f(S275 s) { return s.x; }
struct S276 { float x; };
float f(S276 s) { return s.x; }
struct S277 { float x; };
float f(S277 s) { return s.x; }
struct S278 { float x; };
float f(S278 s) { return s.x; }
struct S279 { float x; };
float f(S279 s) { return s.x; }
struct S280 { float x; };
float f(S280 s) { return s.x; }
struct S281 { float x; };
float f(S281 s) { return s.x; }
struct S282 { float x; };
float f(S282 s) { return s.x; }
struct S283 { float x; };
float f(S283 s) { return s.x; }
struct S284 { float x; };
float f(S284 s) { return s.x; }
struct S285 { float x; };
float f(S285 s) { return s.x; }
struct S286 { float x; };
float f(S286 s) { return s.x; }
struct S287 { float x; };
float f(S287 s) { return s.x; }
struct S288 { float x; };
float f(S288 s) { return s.x; }
struct S289 { float x; };
float f(S289 s) { return s.x; }
struct S290 { float x; };
float f(S290 s) { return s.x; }
struct S291 { float x; };
float f(S291 s) { return s.x; }
struct S292 { float x; };
float f(S292 s) { return s.x; }
struct S293 { float x; };
float f(S293 s) { return s.x; }
struct S294 { float x; };
float f(S294 s) { return s.x; }
struct S295 { float x; };
float f(S295 s) { return s.x; }
struct S296 { float x; };
float f(S296 s) { return s.x; }
struct S297 { float x; };
float f(S297 s) { return s.x; }
struct S298 { float x; };
float f(S298 s) { return s.x; }
struct S299 { float x; };
float f(S299 s) { return s.x; }
struct S300 { float x; };
float f(S300 s) { return s.x; }
struct S301 { float x; };
float f(S301 s) { return s.x; }
struct S302 { float x; };
float f(S302 s) { return s.x; }
struct S303 { float x; };
float f(S303 s) { return s.x; }
struct S304 { float x; };
float f(S304 s) { return s.x; }
struct S305 { float x; };
float f(S305 s) { return s.x; }
struct S306 { float x; };
float f(S306 s) { return s.x; }
struct S307 { float x; };
float f(S307 s) { return s.x; }
struct S308 { float x; };
float f(S308 s) { return s.x; }
struct S309 { float x; };
float f(S309 s) { return s.x; }
struct S310 { float x; };
float f(S310 s) { return s.x; }
struct S311 { float x; };
float f(S311 s) { return s.x; }
struct S312 { float x; };
float f(S312 s) { return s.x; }
struct S313 { float x; };
float f(S313 s) { return s.x; }
struct S314 { float x; };
float f(S314 s) { return s.x; }
struct S315 { float x; };
float f(S315 s) { return s.x; }
struct S316 { float x; };
float f(S316 s) { return s.x; }
struct S317 { float x; };
float f(S317 s) { return s.x; }
struct S318 { float x; };
float f(S318 s) { return s.x; }
struct S319 { float x; };
float f(S319 s) { return s.x; }
struct S320 { float x; };
float f(S320 s) { return s.x; }
struct S321 { float x; };
float f(S321 s) { return s.x; }
struct S322 { float x; };
float f(S322 s) { return s.x; }
struct S323 { float x; };
float f(S323 s) { return s.x; }
struct S324 { float x; };
float f(S324 s) { return s.x; }
struct S325 { float x; };
float f(S325 s) { return s.x; }
struct S326 { float x; };
float f(S326 s) { return s.x; }
struct S327 { float x; };
float f(S327 s) { return s.x; }
struct S328 { float x; };
float f(S328 s) { return s.x; }
struct S329 { float x; };
float f(S329 s) { return s.x; }
struct S330 { float x; };
float f(S330 s) { return s.x; }
struct S331 { float x; };
float f(S331 s) { return s.x; }
struct S332 { float x; };
float f(S332 s) { return s.x; }
struct S333 { float x; };
float f(S333 s) { return s.x; }
struct S334 { float x; };
float f(S334 s) { return s.x; }
struct S335 { float x; };
float f(S335 s) { return s.x; }
struct S336 { float x; };
float f(S336 s) { return s.x; }
struct S337 { float x; };
float f(S337 s) { return s.x; }
struct S338 { float x; };
float f(S338 s) { return s.x; }
struct S339 { float x; };
float f(S339 s) { return s.x; }
struct S340 { float x; };
float f(S340 s) { return s.x; }
struct S341 { float x; };
float f(S341 s) { return s.x; }
struct S342 { float x; };
float f(S342 s) { return s.x; }
struct S343 { float x; };
float f(S343 s) { return s.x; }
struct S344 { float x; };
float f(S344 s) { return s.x; }
struct S345 { float x; };
float f(S345 s) { return s.x; }
struct S346 { float x; };
float f(S346 s) { return s.x; }
struct S347 { float x; };
float f(S347 s) { return s.x; }
struct S348 { float x; };
float f(S348 s) { return s.x; }
struct S349 { float x; };
float f(S349 s) { return s.x; }
struct S350 { float x; };
float f(S350 s) { return s.x; }
struct S351 { float x; };
float f(S351 s) { return s.x; }
struct S352 { float x; };
float f(S352 s) { return s.x; }
struct S353 { float x; };
float f(S353 s) { return s.x; }
struct S354 { float x; };
float f(S354 s) { return s.x; }
struct S355 { float x; };
float f(S355 s) { return s.x; }
struct S356 { float x; };
float f(S356 s) { return s.x; }
struct S357 { float x; };
float f(S357 s) { return s.x; }
struct S358 { float x; };
float f(S358 s) { return s.x; }
struct S359 { float x; };
float f(S359 s) { return s.x; }
struct S360 { float x; };
float f(S360 s) { return s.x; }
struct S361 { float x; };
float f(S361 s) { return s.x; }
struct S362 { float x; };
float f(S362 s) { return s.x; }
struct S363 { float x; };
float f(S363 s) { return s.x; }
struct S364 { float x; };
float f(S364 s) { return s.x; }
struct S365 { float x; };
float f(S365 s) { return s.x; }
struct S366 { float x; };
float f(S366 s) { return s.x; }
struct S367 { float x; };
float f(S367 s) { return s.x; }
struct S368 { float x; };
float f(S368 s) { return s.x; }
struct S369 { float x; };
float f(S369 s) { return s.x; }
struct S370 { float x; };
float f(S370 s) { return s.x; }
struct S371 { float x; };
float f(S371 s) { return s.x; }
struct S372 { float x; };
float f(S372 s) { return s.x; }
struct S373 { float x; };
float f(S373 s) { return s.x; }
struct S374 { float x; };
float f(S374 s) { return s.x; }
struct S375 { float x; };
float f(S375 s) { return s.x; }
struct S376 { float x; };
float f(S376 s) { return s.x; }
struct S377 { float x; };
float f(S377 s) { return s.x; }
struct S378 { float x; };
float f(S378 s) { return s.x; }
struct S379 { float x; };
float f(S379 s) { return s.x; }
struct S380 { float x; };
float f(S380 s) { return s.x; }
struct S381 { float x; };
float f(S381 s) { return s.x; }
struct S382 { float x; };
float f(S382 s) { return s.x; }
struct S383 { float x; };
float f(S383 s) { return s.x; }
struct S384 { float x; };
float f(S384 s) { return s.x; }
struct S385 { float x; };
float f(S385 s) { return s.x; }
struct S386 { float x; };
float f(S386 s) { return s.x; }
struct S387 { float x; };
float f(S387 s) { return s.x; }
struct S388 { float x; };
float f(S388 s) { return s.x; }
struct S389 { float x; };
float f(S389 s) { return s.x; }
struct S390 { float x; };
float f(S390 s) { return s.x; }
struct S391 { float x; };
float f(S391 s) { return s.x; }
struct S392 { float x; };
float f(S392 s) { return s.x; }
struct S393 { float x; };
float f(S393 s) { return s.x; }
struct S394 { float x; };
float f(S394 s) { return s.x; }
struct S395 { float x; };
float f(S395 s) { return s.x; }
struct S396 { float x; };
float f(S396 s) { return s.x; }
struct S397 { float x; };
float f(S397 s) { return s.x; }
struct S398 { float x; };
float f(S398 s) { return s.x; }
struct S399 { float x; };
float f(S399 s) { return s.x; }
struct S400 { float x; };
float f(S400 s) { return s.x; }
struct S401 { float x; };
float f(S401 s) { return s.x; }
struct S402 { float x; };
float f(S402 s) { return s.x; }
struct S403 { float x; };
float f(S403 s) { return s.x; }
struct S404 { float x; };
float f(S404 s) { return s.x; }
struct S405 { float x; };
float f(S405 s) { return s.x; }
struct S406 { float x; };
float f(S406 s) { return s.x; }
struct S407 { float x; };
float f(S407 s) { return s.x; }
struct S408 { float x; };
float f(S408 s) { return s.x; }
struct S409 { float x; };
float f(S409 s) { return s.x; }
struct S410 { float x; };
float f(S410 s) { return s.x; }
struct S411 { float x; };
float f(S411 s) { return s.x; }
struct S412 { float x; };
float f(S412 s) { return s.x; }
struct S413 { float x; };
float f(S413 s) { return s.x; }
struct S414 { float x; };
float f(S414 s) { return s.x; }
struct S415 { float x; };
float f(S415 s) { return s.x; }
struct S416 { float x; };
float f(S416 s) { return s.x; }
struct S417 { float x; };
float f(S417 s) { return s.x; }
struct S418 { float x; };
float f(S418 s) { return s.x; }
struct S419 { float x; };
float f(S419 s) { return s.x; }
struct S420 { float x; };
float f(S420 s) { return s.x; }
struct S421 { float x; };
float f(S421 s) { return s.x; }
struct S422 { float x; };
float f(S422 s) { return s.x; }
struct S423 { float x; };
float f(S423 s) { return s.x; }
struct S424 { float x; };
float f(S424 s) { return s.x; }
struct S425 { float x; };
float f(S425 s) { return s.x; }
struct S426 { float x; };
float f(S426 s) { return s.x; }
struct S427 { float x; };
float f(S427 s) { return s.x; }
struct S428 { float x; };
float f(S428 s) { return s.x; }
struct S429 { float x; };
float f(S429 s) { return s.x; }
struct S430 { float x; };
float f(S430 s) { return s.x; }
struct S431 { float x; };
float f(S431 s) { return s.x; }
struct S432 { float x; };
float f(S432 s) { return s.x; }
struct S433 { float x; };
float f(S433 s) { return s.x; }
struct S434 { float x; };
float f(S434 s) { return s.x; }
struct S435 { float x; };
float f(S435 s) { return s.x; }
struct S436 { float x; };
float f(S436 s) { return s.x; }
struct S437 { float x; };
float f(S437 s) { return s.x; }
struct S438 { float x; };
float f(S438 s) { return s.x; }
struct S439 { float x; };
float f(S439 s) { return s.x; }
struct S440 { float x; };
float f(S440 s) { return s.x; }
struct S441 { float x; };
float f(S441 s) { return s.x; }
struct S442 { float x; };
float f(S442 s) { return s.x; }
struct S443 { float x; };
float f(S443 s) { return s.x; }
struct S444 { float x; };
float f(S444 s) { return s.x; }
struct S445 { float x; };
float f(S445 s) { return s.x; }
struct S446 { float x; };
float f(S446 s) { return s.x; }
struct S447 { float x; };
float f(S447 s) { return s.x; }
struct S448 { float x; };
float f(S448 s) { return s.x; }
struct S449 { float x; };
float f(S449 s) { return s.x; }
struct S450 { float x; };
float f(S450 s) { return s.x; }
struct S451 { float x; };
float f(S451 s) { return s.x; }
struct S452 { float x; };
float f(S452 s) { return s.x; }
struct S453 { float x; };
float f(S453 s) { return s.x; }
struct S454 { float x; };
float f(S454 s) { return s.x; }
struct S455 { float x; };
float f(S455 s) { return s.x; }
struct S456 { float x; };
float f(S456 s) { return s.x; }
struct S457 { float x; };
float f(S457 s) { return s.x; }
struct S458 { float x; };
float f(S458 s) { return s.x; }
struct S459 { float x; };
float f(S459 s) { return s.x; }
struct S460 { float x; };
float f(S460 s) { return s.x; }
struct S461 { float x; };
float f(S461 s) { return s.x; }
struct S462 { float x; };
float f(S462 s) { return s.x; }
struct S463 { float x; };
float f(S463 s) { return s.x; }
struct S464 { float x; };
float f(S464 s) { return s.x; }
struct S465 { float x; };
float f(S465 s) { return s.x; }
struct S466 { float x; };
float f(S466 s) { return s.x; }
struct S467 { float x; };
float f(S467 s) { return s.x; }
struct S468 { float x; };
float f(S468 s) { return s.x; }
struct S469 { float x; };
float f(S469 s) { return s.x; }
struct S470 { float x; };
float f(S470 s) { return s.x; }
struct S471 { float x; };
float f(S471 s) { return s.x; }
struct S472 { float x; };
float f(S472 s) { return s.x; }
struct S473 { float x; };
float f(S473 s) { return s.x; }
struct S474 { float x; };
float f(S474 s) { return s.x; }
struct S475 { float x; };
float f(S475 s) { return s.x; }
struct S476 { float x; };
float f(S476 s) { return s.x; }
struct S477 { float x; };
float f(S477 s) { return s.x; }
struct S478 { float x; };
float f(S478 s) { return s.x; }
struct S479 { float x; };
float f(S479 s) { return s.x; }
struct S480 { float x; };
float f(S480 s) { return s.x; }
struct S481 { float x; };
float f(S481 s) { return s.x; }
struct S482 { float x; };
float f(S482 s) { return s.x; }
struct S483 { float x; };
float f(S483 s) { return s.x; }
struct S484 { float x; };
float f(S484 s) { return s.x; }
struct S485 { float x; };
float f(S485 s) { return s.x; }
struct S486 { float x; };
float f(S486 s) { return s.x; }
struct S487 { float x; };
float f(S487 s) { return s.x; }
struct S488 { float x; };
float f(S488 s) { return s.x; }
struct S489 { float x; };
float f(S489 s) { return s.x; }
struct S490 { float x; };
float f(S490 s) { return s.x; }
struct S491 { float x; };
float f(S491 s) { return s.x; }
struct S492 { float x; };
float f(S492 s) { return s.x; }
struct S493 { float x; };
float f(S493 s) { return s.x; }
struct S494 { float x; };
float f(S494 s) { return s.x; }
struct S495 { float x; };
float f(S495 s) { return s.x; }
struct S496 { float x; };
float f(S496 s) { return s.x; }
struct S497 { float x; };
float f(S497 s) { return s.x; }
struct S498 { float x; };
float f(S498 s) { return s.x; }
struct S499 { float x; };
float f(S499 s) { return s.x; }
struct S500 { float x; };
float f(S500 s) { return s.x; }
struct S501 { float x; };
float f(S501 s) { return s.x; }
struct S502 { float x; };
float f(S502 s) { return s.x; }
struct S503 { float x; };
float f(S503 s) { return s.x; }
struct S504 { float x; };
float f(S504 s) { return s.x; }
struct S505 { float x; };
float f(S505 s) { return s.x; }
struct S506 { float x; };
float f(S506 s) { return s.x; }
struct S507 { float x; };
float f(S507 s) { return s.x; }
struct S508 { float x; };
float f(S508 s) { return s.x; }
struct S509 { float x; };
float f(S509 s) { return s.x; }
struct S510 { float x; };
float f(S510 s) { return s.x; }
struct S511 { float x; };
float f(S511 s) { return s.x; }
struct S512 { float x; };
float f(S512 s) { return s.x; }
struct S513 { float x; };
float f(S513 s) { return s.x; }
struct S514 { float x; };
float f(S514 s) { return s.x; }
struct S515 { float x; };
float f(S515 s) { return s.x; }
struct S516 { float x; };
float f(S516 s) { return s.x; }
struct S517 { float x; };
float f(S517 s) { return s.x; }
struct S518 { float x; };
float f(S518 s) { return s.x; }
struct S519 { float x; };
float f(S519 s) { return s.x; }
struct S520 { float x; };
float f(S520 s) { return s.x; }
struct S521 { float x; };
float f(S521 s) { return s.x; }
struct S522 { float x; };
float f(S522 s) { return s.x; }
struct S523 { float x; };
float f(S523 s) { return s.x; }
struct S524 { float x; };
float f(S524 s) { return s.x; }
struct S525 { float x; };
float f(S525 s) { return s.x; }
struct S526 { float x; };
float f(S526 s) { return s.x; }
struct S527 { float x; };
float f(S527 s) { return s.x; }
struct S528 { float x; };
float f(S528 s) { return s.x; }
struct S529 { float x; };
float f(S529 s) { return s.x; }
struct S530 { float x; };
float f(S530 s) { return s.x; }
struct S531 { float x; };
float f(S531 s) { return s.x; }
struct S532 { float x; };
float f(S532 s) { return s.x; }
struct S533 { float x; };
float f(S533 s) { return s.x; }
struct S534 { float x; };
float f(S534 s) { return s.x; }
struct S535 { float x; };
float f(S535 s) { return s.x; }
struct S536 { float x; };
float f(S536 s) { return s.x; }
struct S537 { float x; };
float f(S537 s) { return s.x; }
struct S538 { float x; };
float f(S538 s) { return s.x; }
struct S539 { float x; };
float f(S539 s) { return s.x; }
struct S540 { float x; };
float f(S540 s) { return s.x; }
struct S541 { float x; };
float f(S541 s) { return s.x; }
struct S542 { float x; };
float f(S542 s) { return s.x; }
struct S543 { float x; };
float f(S543 s) { return s.x; }
struct S544 { float x; };
float f(S544 s) { return s.x; }
struct S545 { float x; };
float f(S545 s) { return s.x; }
struct S546 { float x; };
float f(S546 s) { return s.x; }
struct S547 { float x; };
float f(S547 s) { return s.x; }
struct S548 { float x; };
float f(S548 s) { return s.x; }
struct S549 { float x; };
float f(S549 s) { return s.x; }
struct S550 { float x; };
float f(S550 s) { return s.x; }
struct S551 { float x; };
float f(S551 s) { return s.x; }
struct S552 { float x; };
float f(S552 s) { return s.x; }
struct S553 { float x; };
float f(S553 s) { return s.x; }
struct S554 { float x; };
float f(S554 s) { return s.x; }
struct S555 { float x; };
float f(S555 s) { return s.x; }
struct S556 { float x; };
float f(S556 s) { return s.x; }
struct S557 { float x; };
float f(S557 s) { return s.x; }
struct S558 { float x; };
float f(S558 s) { return s.x; }
struct S559 { float x; };
float f(S559 s) { return s.x; }
struct S560 { float x; };
float f(S560 s) { return s.x; }
struct S561 { float x; };
float f(S561 s) { return s.x; }
struct S562 { float x; };
float f(S562 s) { return s.x; }
struct S563 { float x; };
float f(S563 s) { return s.x; }
struct S564 { float x; };
float f(S564 s) { return s.x; }
struct S565 { float x; };
float f(S565 s) { return s.x; }
struct S566 { float x; };
float f(S566 s) { return s.x; }
struct S567 { float x; };
float f(S567 s) { return s.x; }
struct S568 { float x; };
float f(S568 s) { return s.x; }
struct S569 { float x; };
float f(S569 s) { return s.x; }
struct S570 { float x; };
float f(S570 s) { return s.x; }
struct S571 { float x; };
float f(S571 s) { return s.x; }
struct S572 { float x; };
float f(S572 s) { return s.x; }
struct S573 { float x; };
float f(S573 s) { return s.x; }
struct S574 { float x; };
float f(S574 s) { return s.x; }
struct S575 { float x; };
float f(S575 s) { return s.x; }
struct S576 { float x; };
float f(S576 s) { return s.x; }
struct S577 { float x; };
float f(S577 s) { return s.x; }
struct S578 { float x; };
float f(S578 s) { return s.x; }
struct S579 { float x; };
float f(S579 s) { return s.x; }
struct S580 { float x; };
float f(S580 s) { return s.x; }
struct S581 { float x; };
float f(S581 s) { return s.x; }
struct S582 { float x; };
float f(S582 s) { return s.x; }
struct S583 { float x; };
float f(S583 s) { return s.x; }
struct S584 { float x; };
float f(S584 s) { return s.x; }
struct S585 { float x; };
float f(S585 s) { return s.x; }
struct S586 { float x; };
float f(S586 s) { return s.x; }
struct S587 { float x; };
float f(S587 s) { return s.x; }
struct S588 { float x; };
float f(S588 s) { return s.x; }
struct S589 { float x; };
float f(S589 s) { return s.x; }
struct S590 { float x; };
float f(S590 s) { return s.x; }
struct S591 { float x; };
float f(S591 s) { return s.x; }
struct S592 { float x; };
float f(S592 s) { return s.x; }
struct S593 { float x; };
float f(S593 s) { return s.x; }
struct S594 { float x; };
float f(S594 s) { return s.x; }
struct S595 { float x; };
float f(S595 s) { return s.x; }
struct S596 { float x; };
float f(S596 s) { return s.x; }
struct S597 { float x; };
float f(S597 s) { return s.x; }
struct S598 { float x; };
float f(S598 s) { return s.x; }
struct S599 { float x; };
float f(S599 s) { return s.x; }
struct S600 { float x; };
float f(S600 s) { return s.x; }
struct S601 { float x; };
float f(S601 s) { return s.x; }
struct S602 { float x; };
float f(S602 s) { return s.x; }
struct S603 { float x; };
float f(S603 s) { return s.x; }
struct S604 { float x; };
float f(S604 s) { return s.x; }
struct S605 { float x; };
float f(S605 s) { return s.x; }
struct S606 { float x; };
float f(S606 s) { return s.x; }
struct S607 { float x; };
float f(S607 s) { return s.x; }
struct S608 { float x; };
float f(S608 s) { return s.x; }
struct S609 { float x; };
float f(S609 s) { return s.x; }
struct S610 { float x; };
float f(S610 s) { return s.x; }
struct S611 { float x; };
float f(S611 s) { return s.x; }
struct S612 { float x; };
float f(S612 s) { return s.x; }
struct S613 { float x; };
float f(S613 s) { return s.x; }
struct S614 { float x; };
float f(S614 s) { return s.x; }
struct S615 { float x; };
float f(S615 s) { return s.x; }
struct S616 { float x; };
float f(S616 s) { return s.x; }
struct S617 { float x; };
float f(S617 s) { return s.x; }
struct S618 { float x; };
float f(S618 s) { return s.x; }
struct S619 { float x; };
float f(S619 s) { return s.x; }
struct S620 { float x; };
float f(S620 s) { return s.x; }
struct S621 { float x; };
float f(S621 s) { return s.x; }
struct S622 { float x; };
float f(S622 s) { return s.x; }
struct S623 { float x; };
float f(S623 s) { return s.x; }
struct S624 { float x; };
float f(S624 s) { return s.x; }
struct S625 { float x; };
float f(S625 s) { return s.x; }
struct S626 { float x; };
float f(S626 s) { return s.x; }
struct S627 { float x; };
float f(S627 s) { return s.x; }
struct S628 { float x; };
float f(S628 s) { return s.x; }
struct S629 { float x; };
float f(S629 s) { return s.x; }
struct S630 { float x; };
float f(S630 s) { return s.x; }
struct S631 { float x; };
float f(S631 s) { return s.x; }
struct S632 { float x; };
float f(S632 s) { return s.x; }
struct S633 { float x; };
float f(S633 s) { return s.x; }
struct S634 { float x; };
float f(S634 s) { return s.x; }
struct S635 { float x; };
float f(S635 s) { return s.x; }
struct S636 { float x; };
float f(S636 s) { return s.x; }
struct S637 { float x; };
float f(S637 s) { return s.x; }
struct S638 { float x; };
float f(S638 s) { return s.x; }
struct S639 { float x; };
float f(S639 s) { return s.x; }
struct S640 { float x; };
float f(S640 s) { return s.x; }
struct S641 { float x; };
float f(S641 s) { return s.x; }
struct S642 { float x; };
float f(S642 s) { return s.x; }
struct S643 { float x; };
float f(S643 s) { return s.x; }
struct S644 { float x; };
float f(S644 s) { return s.x; }
struct S645 { float x; };
float f(S645 s) { return s.x; }
struct S646 { float x; };
float f(S646 s) { return s.x; }
struct S647 { float x; };
float f(S647 s) { return s.x; }
struct S648 { float x; };
float f(S648 s) { return s.x; }
struct S649 { float x; };
float f(S649 s) { return s.x; }
struct S650 { float x; };
float f(S650 s) { return s.x; }
struct S651 { float x; };
float f(S651 s) { return s.x; }
struct S652 { float x; };
float f(S652 s) { return s.x; }
struct S653 { float x; };
float f(S653 s) { return s.x; }
struct S654 { float x; };
float f(S654 s) { return s.x; }
struct S655 { float x; };
float f(S655 s) { return s.x; }
struct S656 { float x; };
float f(S656 s) { return s.x; }
struct S657 { float x; };
float f(S657 s) { return s.x; }
struct S658 { float x; };
float f(S658 s) { return s.x; }
struct S659 { float x; };
float f(S659 s) { return s.x; }
struct S660 { float x; };
float f(S660 s) { return s.x; }
struct S661 { float x; };
float f(S661 s) { return s.x; }
struct S662 { float x; };
float f(S662 s) { return s.x; }
struct S663 { float x; };
float f(S663 s) { return s.x; }
struct S664 { float x; };
float f(S664 s) { return s.x; }
struct S665 { float x; };
float f(S665 s) { return s.x; }
struct S666 { float x; };
float f(S666 s) { return s.x; }
struct S667 { float x; };
float f(S667 s) { return s.x; }
struct S668 { float x; };
float f(S668 s) { return s.x; }
struct S669 { float x; };
float f(S669 s) { return s.x; }
struct S670 { float x; };
float f(S670 s) { return s.x; }
struct S671 { float x; };
float f(S671 s) { return s.x; }
struct S672 { float x; };
float f(S672 s) { return s.x; }
struct S673 { float x; };
float f(S673 s) { return s.x; }
struct S674 { float x; };
float f(S674 s) { return s.x; }
struct S675 { float x; };
float f(S675 s) { return s.x; }
struct S676 { float x; };
float f(S676 s) { return s.x; }
struct S677 { float x; };
float f(S677 s) { return s.x; }
struct S678 { float x; };
float f(S678 s) { return s.x; }
struct S679 { float x; };
float f(S679 s) { return s.x; }
struct S680 { float x; };
float f(S680 s) { return s.x; }
struct S681 { float x; };
float f(S681 s) { return s.x; }
struct S682 { float x; };
float f(S682 s) { return s.x; }
struct S683 { float x; };
float f(S683 s) { return s.x; }
struct S684 { float x; };
float f(S684 s) { return s.x; }
struct S685 { float x; };
float f(S685 s) { return s.x; }
struct S686 { float x; };
float f(S686 s) { return s.x; }
struct S687 { float x; };
float f(S687 s) { return s.x; }
struct S688 { float x; };
float f(S688 s) { return s.x; }
struct S689 { float x; };
float f(S689 s) { return s.x; }
struct S690 { float x; };
float f(S690 s) { return s.x; }
struct S691 { float x; };
float f(S691 s) { return s.x; }
struct S692 { float x; };
float f(S692 s) { return s.x; }
struct S693 { float x; };
float f(S693 s) { return s.x; }
struct S694 { float x; };
float f(S694 s) { return s.x; }
struct S695 { float x; };
float f(S695 s) { return s.x; }
struct S696 { float x; };
float f(S696 s) { return s.x; }
struct S697 { float x; };
float f(S697 s) { return s.x; }
struct S698 { float x; };
float f(S698 s) { return s.x; }
struct S699 { float x; };
float f(S699 s) { return s.x; }
struct S700 { float x; };
float f(S700 s) { return s.x; }
struct S701 { float x; };
float f(S701 s) { return s.x; }
struct S702 { float x; };
float f(S702 s) { return s.x; }
struct S703 { float x; };
float f(S703 s) { return s.x; }
struct S704 { float x; };
float f(S704 s) { return s.x; }
struct S705 { float x; };
float f(S705 s) { return s.x; }
struct S706 { float x; };
float f(S706 s) { return s.x; }
struct S707 { float x; };
float f(S707 s) { return s.x; }
struct S708 { float x; };
float f(S708 s) { return s.x; }
struct S709 { float x; };
float f(S709 s) { return s.x; }
struct S710 { float x; };
float f(S710 s) { return s.x; }
struct S711 { float x; };
float f(S711 s) { return s.x; }
struct S712 { float x; };
float f(S712 s) { return s.x; }
struct S713 { float x; };
float f(S713 s) { return s.x; }
struct S714 { float x; };
float f(S714 s) { return s.x; }
struct S715 { float x; };
float f(S715 s) { return s.x; }
struct S716 { float x; };
float f(S716 s) { return s.x; }
struct S717 { float x; };
float f(S717 s) { return s.x; }
struct S718 { float x; };
float f(S718 s) { return s.x; }
struct S719 { float x; };
float f(S719 s) { return s.x; }
struct S720 { float x; };
float f(S720 s) { return s.x; }
struct S721 { float x; };
float f(S721 s) { return s.x; }
struct S722 { float x; };
float f(S722 s) { return s.x; }
struct S723 { float x; };
float f(S723 s) { return s.x; }
struct S724 { float x; };
float f(S724 s) { return s.x; }
struct S725 { float x; };
float f(S725 s) { return s.x; }
struct S726 { float x; };
float f(S726 s) { return s.x; }
struct S727 { float x; };
float f(S727 s) { return s.x; }
struct S728 { float x; };
float f(S728 s) { return s.x; }
struct S729 { float x; };
float f(S729 s) { return s.x; }
struct S730 { float x; };
float f(S730 s) { return s.x; }
struct S731 { float x; };
float f(S731 s) { return s.x; }
struct S732 { float x; };
float f(S732 s) { return s.x; }
struct S733 { float x; };
float f(S733 s) { return s.x; }
struct S734 { float x; };
float f(S734 s) { return s.x; }
struct S735 { float x; };
float f(S735 s) { return s.x; }
struct S736 { float x; };
float f(S736 s) { return s.x; }
struct S737 { float x; };
float f(S737 s) { return s.x; }
struct S738 { float x; };
float f(S738 s) { return s.x; }
struct S739 { float x; };
float f(S739 s) { return s.x; }
struct S740 { float x; };
float f(S740 s) { return s.x; }
struct S741 { float x; };
float f(S741 s) { return s.x; }
struct S742 { float x; };
float f(S742 s) { return s.x; }
struct S743 { float x; };
float f(S743 s) { return s.x; }
struct S744 { float x; };
float f(S744 s) { return s.x; }
struct S745 { float x; };
float f(S745 s) { return s.x; }
struct S746 { float x; };
float f(S746 s) { return s.x; }
struct S747 { float x; };
float f(S747 s) { return s.x; }
struct S748 { float x; };
float f(S748 s) { return s.x; }
struct S749 { float x; };
float f(S749 s) { return s.x; }
struct S750 { float x; };
float f(S750 s) { return s.x; }
struct S751 { float x; };
float f(S751 s) { return s.x; }
struct S752 { float x; };
float f(S752 s) { return s.x; }
struct S753 { float x; };
float f(S753 s) { return s.x; }
struct S754 { float x; };
float f(S754 s) { return s.x; }
struct S755 { float x; };
float f(S755 s) { return s.x; }
struct S756 { float x; };
float f(S756 s) { return s.x; }
struct S757 { float x; };
float f(S757 s) { return s.x; }
struct S758 { float x; };
float f(S758 s) { return s.x; }
struct S759 { float x; };
float f(S759 s) { return s.x; }
struct S760 { float x; };
float f(S760 s) { return s.x; }
struct S761 { float x; };
float f(S761 s) { return s.x; }
struct S762 { float x; };
float f(S762 s) { return s.x; }
struct S763 { float x; };
float f(S763 s) { return s.x; }
struct S764 { float x; };
float f(S764 s) { return s.x; }
struct S765 { float x; };
float f(S765 s) { return s.x; }
struct S766 { float x; };
float f(S766 s) { return s.x; }
struct S767 { float x; };
float f(S767 s) { return s.x; }
struct S768 { float x; };
float f(S768 s) { return s.x; }
struct S769 { float x; };
float f(S769 s) { return s.x; }
struct S770 { float x; };
float f(S770 s) { return s.x; }
struct S771 { float x; };
float f(S771 s) { return s.x; }
struct S772 { float x; };
float f(S772 s) { return s.x; }
struct S773 { float x; };
float f(S773 s) { return s.x; }
struct S774 { float x; };
float f(S774 s) { return s.x; }
struct S775 { float x; };
float f(S775 s) { return s.x; }
struct S776 { float x; };
float f(S776 s) { return s.x; }
struct S777 { float x; };
float f(S777 s) { return s.x; }
struct S778 { float x; };
float f(S778 s) { return s.x; }
struct S779 { float x; };
float f(S779 s) { return s.x; }
struct S780 { float x; };
float f(S780 s) { return s.x; }
struct S781 { float x; };
float f(S781 s) { return s.x; }
struct S782 { float x; };
float f(S782 s) { return s.x; }
struct S783 { float x; };
float f(S783 s) { return s.x; }
struct S784 { float x; };
float f(S784 s) { return s.x; }
struct S785 { float x; };
float f(S785 s) { return s.x; }
struct S786 { float x; };
float f(S786 s) { return s.x; }
struct S787 { float x; };
float f(S787 s) { return s.x; }
struct S788 { float x; };
float f(S788 s) { return s.x; }
struct S789 { float x; };
float f(S789 s) { return s.x; }
struct S790 { float x; };
float f(S790 s) { return s.x; }
struct S791 { float x; };
float f(S791 s) { return s.x; }
struct S792 { float x; };
float f(S792 s) { return s.x; }
struct S793 { float x; };
float f(S793 s) { return s.x; }
struct S794 { float x; };
float f(S794 s) { return s.x; }
struct S795 { float x; };
float f(S795 s) { return s.x; }
struct S796 { float x; };
float f(S796 s) { return s.x; }
struct S797 { float x; };
float f(S797 s) { return s.x; }
struct S798 { float x; };
float f(S798 s) { return s.x; }
struct S799 { float x; };
float f(S799 s) { return s.x; }
struct S800 { float x; };
float f(S800 s) { return s.x; }
struct S801 { float x; };
float f(S801 s) { return s.x; }
struct S802 { float x; };
float f(S802 s) { return s.x; }
struct S803 { float x; };
float f(S803 s) { return s.x; }
struct S804 { float x; };
float f(S804 s) { return s.x; }
struct S805 { float x; };
float f(S805 s) { return s.x; }
struct S806 { float x; };
float f(S806 s) { return s.x; }
struct S807 { float x; };
float f(S807 s) { return s.x; }
struct S808 { float x; };
float f(S808 s) { return s.x; }
struct S809 { float x; };
float f(S809 s) { return s.x; }
struct S810 { float x; };
float f(S810 s) { return s.x; }
struct S811 { float x; };
float f(S811 s) { return s.x; }
struct S812 { float x; };
float f(S812 s) { return s.x; }
struct S813 { float x; };
float f(S813 s) { return s.x; }
struct S814 { float x; };
float f(S814 s) { return s.x; }
struct S815 { float x; };
float f(S815 s) { return s.x; }
struct S816 { float x; };
float f(S816 s) { return s.x; }
struct S817 { float x; };
float f(S817 s) { return s.x; }
struct S818 { float x; };
float f(S818 s) { return s.x; }
struct S819 { float x; };
float f(S819 s) { return s.x; }
struct S820 { float x; };
float f(S820 s) { return s.x; }
struct S821 { float x; };
float f(S821 s) { return s.x; }
struct S822 { float x; };
float f(S822 s) { return s.x; }
struct S823 { float x; };
float f(S823 s) { return s.x; }
struct S824 { float x; };
float f(S824 s) { return s.x; }
struct S825 { float x; };
float f(S825 s) { return s.x; }
struct S826 { float x; };
float f(S826 s) { return s.x; }
struct S827 { float x; };
float f(S827 s) { return s.x; }
struct S828 { float x; };
float f(S828 s) { return s.x; }
struct S829 { float x; };
float f(S829 s) { return s.x; }
struct S830 { float x; };
float f(S830 s) { return s.x; }
struct S831 { float x; };
float f(S831 s) { return s.x; }
struct S832 { float x; };
float f(S832 s) { return s.x; }
struct S833 { float x; };
float f(S833 s) { return s.x; }
struct S834 { float x; };
float f(S834 s) { return s.x; }
struct S835 { float x; };
float f(S835 s) { return s.x; }
struct S836 { float x; };
float f(S836 s) { return s.x; }
struct S837 { float x; };
float f(S837 s) { return s.x; }
struct S838 { float x; };
float f(S838 s) { return s.x; }
struct S839 { float x; };
float f(S839 s) { return s.x; }
struct S840 { float x; };
float f(S840 s) { return s.x; }
struct S841 { float x; };
float f(S841 s) { return s.x; }
struct S842 { float x; };
float f(S842 s) { return s.x; }
struct S843 { float x; };
float f(S843 s) { return s.x; }
struct S844 { float x; };
float f(S844 s) { return s.x; }
struct S845 { float x; };
float f(S845 s) { return s.x; }
struct S846 { float x; };
float f(S846 s) { return s.x; }
struct S847 { float x; };
float f(S847 s) { return s.x; }
struct S848 { float x; };
float f(S848 s) { return s.x; }
struct S849 { float x; };
float f(S849 s) { return s.x; }
struct S850 { float x; };
float f(S850 s) { return s.x; }
struct S851 { float x; };
float f(S851 s) { return s.x; }
struct S852 { float x; };
float f(S852 s) { return s.x; }
struct S853 { float x; };
float f(S853 s) { return s.x; }
struct S854 { float x; };
float f(S854 s) { return s.x; }
struct S855 { float x; };
float f(S855 s) { return s.x; }
struct S856 { float x; };
float f(S856 s) { return s.x; }
struct S857 { float x; };
float f(S857 s) { return s.x; }
struct S858 { float x; };
float f(S858 s) { return s.x; }
struct S859 { float x; };
float f(S859 s) { return s.x; }
struct S860 { float x; };
float f(S860 s) { return s.x; }
struct S861 { float x; };
float f(S861 s) { return s.x; }
struct S862 { float x; };
float f(S862 s) { return s.x; }
struct S863 { float x; };
float f(S863 s) { return s.x; }
struct S864 { float x; };
float f(S864 s) { return s.x; }
struct S865 { float x; };
float f(S865 s) { return s.x; }
struct S866 { float x; };
float f(S866 s) { return s.x; }
struct S867 { float x; };
float f(S867 s) { return s.x; }
struct S868 { float x; };
float f(S868 s) { return s.x; }
struct S869 { float x; };
float f(S869 s) { return s.x; }
struct S870 { float x; };
float f(S870 s) { return s.x; }
struct S871 { float x; };
float f(S871 s) { return s.x; }
struct S872 { float x; };
float f(S872 s) { return s.x; }
struct S873 { float x; };
float f(S873 s) { return s.x; }
struct S874 { float x; };
float f(S874 s) { return s.x; }
struct S875 { float x; };
float f(S875 s) { return s.x; }
struct S876 { float x; };
float f(S876 s) { return s.x; }
struct S877 { float x; };
float f(S877 s) { return s.x; }
struct S878 { float x; };
float f(S878 s) { return s.x; }
struct S879 { float x; };
float f(S879 s) { return s.x; }
struct S880 { float x; };
float f(S880 s) { return s.x; }
struct S881 { float x; };
float f(S881 s) { return s.x; }
struct S882 { float x; };
float f(S882 s) { return s.x; }
struct S883 { float x; };
float f(S883 s) { return s.x; }
struct S884 { float x; };
float f(S884 s) { return s.x; }
struct S885 { float x; };
float f(S885 s) { return s.x; }
struct S886 { float x; };
float f(S886 s) { return s.x; }
struct S887 { float x; };
float f(S887 s) { return s.x; }
struct S888 { float x; };
float f(S888 s) { return s.x; }
struct S889 { float x; };
float f(S889 s) { return s.x; }
struct S890 { float x; };
float f(S890 s) { return s.x; }
struct S891 { float x; };
float f(S891 s) { return s.x; }
struct S892 { float x; };
float f(S892 s) { return s.x; }
struct S893 { float x; };
float f(S893 s) { return s.x; }
struct S894 { float x; };
float f(S894 s) { return s.x; }
struct S895 { float x; };
float f(S895 s) { return s.x; }
struct S896 { float x; };
float f(S896 s) { return s.x; }
struct S897 { float x; };
float f(S897 s) { return s.x; }
struct S898 { float x; };
float f(S898 s) { return s.x; }
struct S899 { float x; };
float f(S899 s) { return s.x; }
struct S900 { float x; };
float f(S900 s) { return s.x; }
struct S901 { float x; };
float f(S901 s) { return s.x; }
struct S902 { float x; };
float f(S902 s) { return s.x; }
struct S903 { float x; };
float f(S903 s) { return s.x; }
struct S904 { float x; };
float f(S904 s) { return s.x; }
struct S905 { float x; };
float f(S905 s) { return s.x; }
struct S906 { float x; };
float f(S906 s) { return s.x; }
struct S907 { float x; };
float f(S907 s) { return s.x; }
struct S908 { float x; };
float f(S908 s) { return s.x; }
struct S909 { float x; };
float f(S909 s) { return s.x; }
struct S910 { float x; };
float f(S910 s) { return s.x; }
struct S911 { float x; };
float f(S911 s) { return s.x; }
struct S912 { float x; };
float f(S912 s) { return s.x; }
struct S913 { float x; };
float f(S913 s) { return s.x; }
struct S914 { float x; };
float f(S914 s) { return s.x; }
struct S915 { float x; };
float f(S915 s) { return s.x; }
struct S916 { float x; };
float f(S916 s) { return s.x; }
struct S917 { float x; };
float f(S917 s) { return s.x; }
struct S918 { float x; };
float f(S918 s) { return s.x; }
struct S919 { float x; };
float f(S919 s) { return s.x; }
struct S920 { float x; };
float f(S920 s) { return s.x; }
struct S921 { float x; };
float f(S921 s) { return s.x; }
struct S922 { float x; };
float f(S922 s) { return s.x; }
struct S923 { float x; };
float f(S923 s) { return s.x; }
struct S924 { float x; };
float f(S924 s) { return s.x; }
struct S925 { float x; };
float f(S925 s) { return s.x; }
struct S926 { float x; };
float f(S926 s) { return s.x; }
struct S927 { float x; };
float f(S927 s) { return s.x; }
struct S928 { float x; };
float f(S928 s) { return s.x; }
struct S929 { float x; };
float f(S929 s) { return s.x; }
struct S930 { float x; };
float f(S930 s) { return s.x; }
struct S931 { float x; };
float f(S931 s) { return s.x; }
struct S932 { float x; };
float f(S932 s) { return s.x; }
struct S933 { float x; };
float f(S933 s) { return s.x; }
struct S934 { float x; };
float f(S934 s) { return s.x; }
struct S935 { float x; };
float f(S935 s) { return s.x; }
struct S936 { float x; };
float f(S936 s) { return s.x; }
struct S937 { float x; };
float f(S937 s) { return s.x; }
struct S938 { float x; };
float f(S938 s) { return s.x; }
struct S939 { float x; };
float f(S939 s) { return s.x; }
struct S940 { float x; };
float f(S940 s) { return s.x; }
struct S941 { float x; };
float f(S941 s) { return s.x; }
struct S942 { float x; };
float f(S942 s) { return s.x; }
struct S943 { float x; };
float f(S943 s) { return s.x; }
struct S944 { float x; };
float f(S944 s) { return s.x; }
struct S945 { float x; };
float f(S945 s) { return s.x; }
struct S946 { float x; };
float f(S946 s) { return s.x; }
struct S947 { float x; };
float f(S947 s) { return s.x; }
struct S948 { float x; };
float f(S948 s) { return s.x; }
struct S949 { float x; };
float f(S949 s) { return s.x; }
struct S950 { float x; };
float f(S950 s) { return s.x; }
struct S951 { float x; };
float f(S951 s) { return s.x; }
struct S952 { float x; };
float f(S952 s) { return s.x; }
struct S953 { float x; };
float f(S953 s) { return s.x; }
struct S954 { float x; };
float f(S954 s) { return s.x; }
struct S955 { float x; };
float f(S955 s) { return s.x; }
struct S956 { float x; };
float f(S956 s) { return s.x; }
struct S957 { float x; };
float f(S957 s) { return s.x; }
struct S958 { float x; };
float f(S958 s) { return s.x; }
struct S959 { float x; };
float f(S959 s) { return s.x; }
struct S960 { float x; };
float f(S960 s) { return s.x; }
struct S961 { float x; };
float f(S961 s) { return s.x; }
struct S962 { float x; };
float f(S962 s) { return s.x; }
struct S963 { float x; };
float f(S963 s) { return s.x; }
struct S964 { float x; };
float f(S964 s) { return s.x; }
struct S965 { float x; };
float f(S965 s) { return s.x; }
struct S966 { float x; };
float f(S966 s) { return s.x; }
struct S967 { float x; };
float f(S967 s) { return s.x; }
struct S968 { float x; };
float f(S968 s) { return s.x; }
struct S969 { float x; };
float f(S969 s) { return s.x; }
struct S970 { float x; };
float f(S970 s) { return s.x; }
struct S971 { float x; };
float f(S971 s) { return s.x; }
struct S972 { float x; };
float f(S972 s) { return s.x; }
struct S973 { float x; };
float f(S973 s) { return s.x; }
struct S974 { float x; };
float f(S974 s) { return s.x; }
struct S975 { float x; };
float f(S975 s) { return s.x; }
struct S976 { float x; };
float f(S976 s) { return s.x; }
struct S977 { float x; };
float f(S977 s) { return s.x; }
struct S978 { float x; };
float f(S978 s) { return s.x; }
struct S979 { float x; };
float f(S979 s) { return s.x; }
struct S980 { float x; };
float f(S980 s) { return s.x; }
struct S981 { float x; };
float f(S981 s) { return s.x; }
struct S982 { float x; };
float f(S982 s) { return s.x; }
struct S983 { float x; };
float f(S983 s) { return s.x; }
struct S984 { float x; };
float f(S984 s) { return s.x; }
struct S985 { float x; };
float f(S985 s) { return s.x; }
struct S986 { float x; };
float f(S986 s) { return s.x; }
struct S987 { float x; };
float f(S987 s) { return s.x; }
struct S988 { float x; };
float f(S988 s) { return s.x; }
struct S989 { float x; };
float f(S989 s) { return s.x; }
struct S990 { float x; };
float f(S990 s) { return s.x; }
struct S991 { float x; };
float f(S991 s) { return s.x; }
struct S992 { float x; };
float f(S992 s) { return s.x; }
struct S993 { float x; };
float f(S993 s) { return s.x; }
struct S994 { float x; };
float f(S994 s) { return s.x; }
struct S995 { float x; };
float f(S995 s) { return s.x; }
struct S996 { float x; };
float f(S996 s) { return s.x; }
struct S997 { float x; };
float f(S997 s) { return s.x; }
struct S998 { float x; };
float f(S998 s) { return s.x; }
struct S999 { float x; };
float f(S999 s) { return s.x; }
float asked(float x) { return f(S7(2.0 * x)); }
